#include "ui/panels/unit_rows.h"

#include "core/mtg/feature_edits.h"
#include "core/mtg/unit_edits.h"
#include "core/mtg/unit_scales.h"
#include "ui/document/plant_document.h"
#include "ui/panels/units_form.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

QString nameOf(const Entity& entity) {
  return QString::fromStdString(entity.symbol) +
         (entity.index ? QString::fromStdString(entity.index->text()) : QString());
}

QString valueIn(const std::vector<FeatureValue>& values, const std::string& feature) {
  const auto found = std::ranges::find(values, feature, &FeatureValue::feature);
  return found == values.end() ? QString() : QString::fromStdString(found->text);
}

/// The entity whose lines are made, and what all of them need.
struct Subject {
  NodeId start{};
  const Entity& entity;
  bool isNode = false;
  const Mtg* base = nullptr;
  const std::vector<MtgFeature>& added;
  QString name;
  QString end; // of ids: "_2"
};

UnitRow featureRow(const Subject& of, const MtgFeature& feature, const QString& value,
                   std::optional<std::size_t> date) {
  const QString label = QString::fromStdString(feature.name);
  const QString later = date ? QStringLiteral("_later%1").arg(*date) : QString();
  return {"feature_" + label + of.end + later,
          label,
          value,
          UnitsForm::tr("Of type %1").arg(QString::fromStdString(feature.type)),
          UnitsForm::tr("Set %1 of %2").arg(label, of.name),
          [start = of.start, scale = of.entity.scale, base = of.base, feature,
           date](SkeletonEditor& editor, const std::string& text) {
            setFeature(editor, start, scale, {feature, text, date}, base);
          }};
}

QList<UnitRow> labelRows(const Subject& of) {
  const NodeId start = of.start;
  const int scale = of.entity.scale;
  const Mtg* base = of.base;
  return {{"class" + of.end, UnitsForm::tr("Class"), QString::fromStdString(of.entity.symbol),
           UnitsForm::tr("Letters alone"), UnitsForm::tr("Set the class of %1").arg(of.name),
           [=](SkeletonEditor& editor, const std::string& text) {
             setClass(editor, start, scale, text, base);
           }},
          {"index" + of.end, UnitsForm::tr("Index"),
           of.entity.index ? QString::fromStdString(of.entity.index->text()) : QString(),
           UnitsForm::tr("A whole number, two parted by a dot (16.1), or nothing"),
           UnitsForm::tr("Set the index of %1").arg(of.name),
           [=](SkeletonEditor& editor, const std::string& text) {
             setIndex(editor, start, scale, text);
           }},
          {"alias" + of.end, UnitsForm::tr("Alias"), QString::fromStdString(of.entity.alias),
           UnitsForm::tr("Its name in the file, or nothing"),
           UnitsForm::tr("Set the alias of %1").arg(of.name),
           [=](SkeletonEditor& editor, const std::string& text) {
             setAlias(editor, start, scale, text);
           }}};
}

/// "At 01/05/98", by the date among the values; by its place if none is.
QString headingOf(const std::vector<FeatureValue>& values, const std::vector<MtgFeature>& features,
                  std::size_t date) {
  for (const FeatureValue& value : values) {
    const auto feature = std::ranges::find(features, value.feature, &MtgFeature::name);
    if (feature != features.end() && feature->type.find("DD/MM") != std::string::npos)
      return UnitsForm::tr("At %1").arg(QString::fromStdString(value.text));
  }
  return UnitsForm::tr("At later date %1").arg(date + 1);
}

QList<UnitRow> laterRows(const Subject& of) {
  QList<UnitRow> rows;
  for (std::size_t date = 0; date < of.entity.later.size(); ++date) {
    const std::vector<FeatureValue>& values = of.entity.later[date];
    const auto features = typedFeaturesLater(of.entity, date, of.base, of.added);
    QString heading = headingOf(values, features, date);
    for (const MtgFeature& feature : features) {
      rows.append(featureRow(of, feature, valueIn(values, feature.name), date));
      rows.back().heading = std::exchange(heading, {});
    }
  }
  return rows;
}

UnitPart partOf(const Subject& of) {
  UnitPart part{.id = "unit" + of.end, .start = of.start, .scale = of.entity.scale};
  part.name = of.name;
  part.title = (of.isNode ? UnitsForm::tr("As %1, scale %2") : UnitsForm::tr("In %1, scale %2"))
                   .arg(nameOf(of.entity))
                   .arg(of.entity.scale);
  part.rows = labelRows(of);
  for (const MtgFeature& feature : typedFeatures(of.entity, of.isNode, of.base, of.added))
    part.rows.append(featureRow(of, feature, valueIn(of.entity.values, feature.name), {}));
  part.rows.append(laterRows(of));
  part.canDate = !typedFeaturesLater(of.entity, of.entity.later.size(), of.base, of.added).empty();
  return part;
}

} // namespace

const Mtg* baseOf(const PlantDocument& document) {
  return document.structure().frame ? &document.structure().frame->mtg : nullptr;
}

QList<UnitPart> unitParts(const PlantDocument& document, NodeId id) {
  const Skeleton& skeleton = document.skeleton();
  if (!hasEntities(skeleton))
    return {{.id = "unit_2",
             .title = UnitsForm::tr("No features yet"),
             .start = id,
             .scale = 2,
             .name = UnitsForm::tr("node %1").arg(indexOf(id))}};
  const Mtg* base = baseOf(document);
  const std::vector<MtgFeature> added = addedFeatures(skeleton, base);
  const auto endOf = [](const Entity& entity) { return QStringLiteral("_%1").arg(entity.scale); };
  const Entity own = ownEntity(skeleton, id);
  QList<UnitPart> parts = {
      partOf({id, own, true, base, added, UnitsForm::tr("node %1").arg(indexOf(id)), endOf(own)})};
  std::vector<UnitPlace> units = unitsOf(skeleton, id);
  std::ranges::reverse(units);
  for (const UnitPlace& unit : units) {
    const Entity& entity = skeleton[unit.start].entities[unit.entity];
    UnitPart part = partOf({unit.start, entity, false, base, added, nameOf(entity), endOf(entity)});
    part.canBegin = skeleton[id].parent.has_value();
    part.begins = unit.start == id;
    part.step = (part.begins ? UnitsForm::tr("End %1 at node %2")
                             : UnitsForm::tr("Begin a unit like %1 at node %2"))
                    .arg(nameOf(entity))
                    .arg(indexOf(id));
    part.beginOrEnd = [id, scale = entity.scale, ends = part.begins](SkeletonEditor& editor) {
      (ends ? endUnit : beginUnit)(editor, id, scale);
    };
    parts.append(part);
  }
  return parts;
}

} // namespace espalier
