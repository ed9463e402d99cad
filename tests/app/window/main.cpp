#include <QApplication>
#include <gtest/gtest.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // the tests answer them
  const QApplication application(argc, argv);
  QApplication::setApplicationName("Espalier");
  const int status = RUN_ALL_TESTS();
#ifdef __SANITIZE_ADDRESS__
  // Now, not at the end: by then the driver of OpenGL is unloaded, and what it alone points to
  // would count as lost.
  __lsan_do_leak_check();
#endif
  return status;
}
