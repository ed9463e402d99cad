#include "ui/panels/blend_bar.h"

#include "ui/panels/option_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace espalier {

BlendBar::BlendBar(QWidget* parent)
    : QFrame(parent), slider_(new OptionSlider), displacements_(new QToolButton) {
  setObjectName("blend_bar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 4, 4, 4);
  row->setSpacing(8);
  row->addStretch();
  row->addWidget(new QLabel(tr("Scanned")));
  slider_->setObjectName("blend_slider");
  slider_->setAccessibleName(tr("How far points have gone to where they are contracted"));
  slider_->setToolTip(tr("Moves the points between where they were scanned and where contraction "
                         "puts them"));
  slider_->setFixedWidth(200);
  slider_->setDefaultPlace(1);
  slider_->setPlace(1);
  row->addWidget(slider_);
  row->addWidget(new QLabel(tr("Contracted")));
  displacements_->setObjectName("blend_ways");
  displacements_->setProperty("role", "panel");
  displacements_->setText(tr("Displacements"));
  displacements_->setToolTip(tr("Shows a line from where a point was scanned to where it is now"));
  displacements_->setCheckable(true);
  row->addWidget(displacements_);
  auto* close = new QPushButton(QStringLiteral("✕"));
  close->setObjectName("blend_close");
  close->setAccessibleName(tr("Close"));
  close->setToolTip(tr("Shows points and contracted points as usual"));
  close->setFlat(true);
  row->addStretch();
  row->addWidget(close);
  connect(slider_, &QSlider::valueChanged, this, &BlendBar::changed);
  connect(slider_, &OptionSlider::defaultRequested, this, [this] { slider_->setPlace(1); });
  connect(displacements_, &QToolButton::toggled, this, &BlendBar::changed);
  connect(close, &QPushButton::clicked, this, &BlendBar::closeRequested);
}

double BlendBar::blend() const {
  return slider_->place();
}

void BlendBar::setBlend(double blend) {
  slider_->setPlace(blend);
}

bool BlendBar::showsDisplacements() const {
  return displacements_->isChecked();
}

} // namespace espalier
