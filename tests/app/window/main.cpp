#include "tests/app/window/asked_texts.h"

#include <QApplication>
#include <gtest/gtest.h>

#include <iostream>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // the tests answer them
  const QApplication application(argc, argv);
  QApplication::setApplicationName("Espalier");
  espalier::test::AskedTexts asked;
  QApplication::installTranslator(&asked);
  int status = RUN_ALL_TESTS();
  QApplication::removeTranslator(&asked);
  for (const QString& text : asked.missing()) {
    std::cerr << "No French, or another class, in espalier_fr.ts: " << text.toStdString() << '\n';
    status = 1;
  }
#ifdef __SANITIZE_ADDRESS__
  // Now, not at the end: by then the driver of OpenGL is unloaded, and what it alone points to
  // would count as lost.
  __lsan_do_leak_check();
#endif
  return status;
}
