#include "ui/panels/vertex_page.h"

#include "ui/document/length_unit.h"
#include "ui/panels/vertex_model.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace espalier {
namespace {

constexpr int mostOpened = 2000; // rows that are unfolded at once

QLabel* vertexLabel(const char* role, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setProperty("role", role);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

} // namespace

VertexPage::VertexPage(QWidget* parent)
    : QWidget(parent), headline_(vertexLabel("headline", this)),
      advice_(vertexLabel("quiet", this)), counts_(vertexLabel("", this)),
      model_(new VertexModel(this)), tree_(new QTreeView(this)) {
  setObjectName("vertex_page");
  setAttribute(Qt::WA_StyledBackground); // a plain widget paints no background of a style sheet
  headline_->setObjectName("vertex_headline");
  counts_->setObjectName("vertex_counts");
  tree_->setObjectName("vertex_tree");
  tree_->setAccessibleName(tr("Vertices"));
  tree_->setModel(model_);
  tree_->setUniformRowHeights(true);
  tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree_->header()->setStretchLastSection(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 20, 24, 16);
  column->setSpacing(8);
  for (QWidget* part : {headline_, advice_, counts_})
    column->addWidget(part);
  column->addWidget(tree_, 1);
}

void VertexPage::setFile(const QString& name) {
  headline_->setText(tr("%1 has no positions").arg(name));
}

void VertexPage::show(const std::shared_ptr<const MtgFrame>& frame, const QString& keys) {
  if (frame == frame_) return;
  frame_ = frame;
  model_->show(frame);
  if (!frame) return;
  advice_->setText(
      tr("It describes a plant without its shape, so there is nothing to see in space. "
         "Its scales and features are below; %1 writes it as MTG or OPF. To see the "
         "plant, give the vertices of one scale the features XX, YY and ZZ in the "
         "file, and open it again.")
          .arg(keys));
  counts_->setText(describe(frame->mtg));
  if (frame->mtg.vertices.size() <= mostOpened)
    tree_->expandAll();
  else
    tree_->expandToDepth(0);
  constexpr int widest = 320;
  for (int i = 0; i < model_->columnCount(); ++i) {
    tree_->resizeColumnToContents(i);
    tree_->setColumnWidth(i, std::min(tree_->columnWidth(i) + 12, widest));
  }
}

QString describe(const Mtg& mtg) {
  std::map<int, std::map<std::string, int>> classes;
  int successors = 0;
  int branchings = 0;
  for (const MtgVertex& vertex : mtg.vertices) {
    ++classes[vertex.scale][vertex.symbol];
    if (vertex.parent) ++(vertex.edge == EdgeType::successor ? successors : branchings);
  }
  QStringList sentences;
  for (const auto& [scale, counts] : classes) {
    QStringList parts;
    for (const auto& [symbol, count] : counts)
      parts.append(formatCount(static_cast<std::size_t>(count)) + ' ' +
                   QString::fromStdString(symbol));
    sentences.append(VertexPage::tr("Scale %1: %2").arg(scale).arg(parts.join(", ")));
  }
  sentences.append(VertexPage::tr("Edges: %1 <, %2 +").arg(successors).arg(branchings));
  return sentences.join(QStringLiteral("  ·  "));
}

} // namespace espalier
