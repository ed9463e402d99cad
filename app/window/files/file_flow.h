#pragma once

#include "app/window/files/load_files.h"
#include "app/window/files/project_flow.h"
#include "app/window/files/scan_fit.h"
#include "app/window/files/scan_question.h"
#include "app/window/frame/window_part.h"
#include "core/mtg/mtg_of_skeleton.h"

#include <QStringList>

#include <functional>
#include <optional>

class QMenu;
class QSettings;
class QWidget;

namespace espalier {

class ActionSet;
class JobSlot;
class PlantDocument;
class RecentFiles;
struct Format;

/// Opening and saving: the dialogs, the jobs, and the question before unsaved work is lost.
class FileFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    ActionSet& actions;
    ProjectFlow& projects;
    RecentFiles& recent;
    QSettings& settings;
    QWidget& window;
    std::function<std::optional<Eigen::AlignedBox3d>()> clipBox; // of the view [L]; none: all
    std::function<bool()> mayLeaveScan; // asks about work on it that no project keeps
  };
  explicit FileFlow(const Parts& parts);

  /// A project replaces all; a structure replaces the skeleton; a scan comes under a skeleton that
  /// has none. Where there is a scan already, or two are opened, it is asked whether the other is
  /// to be registered to it; else it begins another plant. Where something has to be decided of a
  /// scan before it is read, that is asked first. Reading goes on as a job; only once all is read
  /// is it asked what to do with unsaved edits that it would replace.
  /// @throws Error if a file cannot be read or a job is running
  void open(const QStringList& paths);
  /// The same of one file, which is a plant of its own: a scan is not asked about as another one of
  /// the plant that is open, nor comes under its skeleton.
  void openPlant(const QString& path);
  /// As open(), but how a scan is read is asked first, in any case.
  void openWithChoices(const QStringList& paths);

  /// Reads another scan of the plant, as a job, and hands it out; how it is to be read is asked
  /// where that is in doubt.
  /// @throws Error if a job is running
  void readOther(const QString& path, const std::function<void(LoadedFiles)>& take);

  /// Opens what of the scan lies in the clip's box, all of its points, as another plant.
  /// @throws Error if the scan is shown whole, or the view is not clipped to a box
  void openRegion();

  [[nodiscard]] bool showsPart() const { return part_.isPart(); } // of the file of the scan
  [[nodiscard]] QString count() const override; // of how many points the scan shows a part
  void setPlantShown(bool isShown) override;
  [[nodiscard]] bool mayClose() override;

signals:
  void opened();
  void registrationAsked(const QString& scan); // of another scan to the one that is open
  void movedOntoScan();                        // the structure, as was offered
  void closed();

private:
  void addActions();        // file_actions.cpp
  void addProjectActions(); // likewise
  void fillRecent(QMenu& menu);
  void refreshProject();
  /// Files that are to be opened, and how.
  struct Opening {
    QStringList paths;
    ScanRequest request;
    Asking asking = Asking::ifUnclear;
    bool isPlant = false;                // of its own, whatever is open
    QString toRegister = {};             // a scan, once these are shown
    std::optional<LengthUnit> unit = {}; // of the scan; none: as it seems
    std::optional<UpAxis> up = {};       // likewise
    /// Takes another scan of the plant; none: it is opened.
    std::function<void(LoadedFiles)> take = {};
    std::optional<ScanLook> look = {};      // at the scan, if it was asked about
    std::optional<ScanChoices> chosen = {}; // what was answered
  };
  void chooseAndOpen(Asking asking);
  void open(const QStringList& paths, Asking asking);
  void openScans(const QStringList& scans, const QStringList& structures, Asking asking);
  void read(const Opening& opening);
  /// What is to be done with a second scan; left: nothing, the user went back.
  enum class Second : std::uint8_t { opened, registered, left };
  [[nodiscard]] Second askAbout(const QString& another) const; // file_questions.cpp
  [[nodiscard]] Second askAboutTwo(const QString& first, const QString& second) const; // likewise
  void ask(Opening opening, const ScanLook& look);                                     // likewise
  void setPart(const ScanPart& part);
  void closePlant();

  /// Each returns whether the skeleton is saved now; the user may have left the dialog, or chosen a
  /// format that cannot be opened again.
  /// @throws Error why it cannot be written
  bool save();
  bool saveAs();
  /// Writes a copy of the skeleton: the document stays where it is.
  /// @throws Error why it cannot be written
  void exportStructure();
  /// Asks what to do with unsaved edits, if there are any. False: keep editing.
  /// @throws Error if they are to be saved and cannot be
  [[nodiscard]] bool mayDiscard();
  /// Asks first about the work that would be lost.
  void showUnlessKept(const std::function<void()>& show, bool isAnotherPlant);
  /// Files as they were read, and how the structure then lies to the scan.
  struct Read {
    std::optional<ScanLook> look; // at a scan to ask about: nothing is read before the answer
    LoadedFiles files;
    ScanFit fit;
    std::optional<LengthUnit> unit; // of the scan, if it is known
    std::optional<UpAxis> up;       // likewise
  };
  static Read readOrAsk(Opening opening, const NamedColumns& known, const Progress& progress);
  static std::optional<ScanLook> lookAt(const Opening& opening, const NamedColumns& known);
  void finish(const Opening& opening, Read read, bool isAnotherPlant);
  void remember(const QString& alike, const std::vector<PointField>& columns);
  void show(Read read, bool isAnotherPlant);
  bool reportFit(const ScanFit& fit, QStringList notes); // whether there was anything to report
  struct Target {
    QString path; // empty: none was chosen
    MtgStyle style = MtgStyle::plantNode;
    const Format* format = nullptr; // null: as the name says
  };
  [[nodiscard]] MtgStyle preferredStyle() const; // as chosen last
  [[nodiscard]] Target chooseTarget(const QString& title);
  void write(const Target& target, const QString& note); // "Saved %1"
  void writeTo(const Target& target);                    // and counts as saved from then on
  [[nodiscard]] QStringList droppedBySavingAs(const Format& format) const; // sentences

  Parts parts_;
  Target saved_;       // where and how the skeleton was written last
  ScanPart part_;      // what of its file the scan is
  QString copied_;     // the file of others that a copy was kept of
  NamedColumns named_; // by hand
};

} // namespace espalier
