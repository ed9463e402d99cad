#include "core/base/error.h"
#include "core/project/seal.h"
#include "core/project/structure_hash.h"
#include "core/skeleton/edits.h"
#include "tests/core/io/samples.h"
#include "tests/core/project/edits_at_random.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::HasSubstr;

constexpr std::int64_t minute = 60'000; // [ms]

/// A history that is made edit by edit, at given times.
struct Work {
  History history = {.skeleton = test::fork(3)};

  void step(std::int64_t time, const std::function<void(SkeletonEditor&)>& change) {
    SkeletonEditor editor(history.skeleton);
    change(editor);
    history.steps.push_back(
        {.text = "Edit", .author = "Anna", .time = time, .delta = editor.commit()});
    ++history.position;
  }
  void reviewAll(std::int64_t time) {
    step(time, [](SkeletonEditor& editor) {
      for (const NodeId id : editor.skeleton().ids())
        editor.setReview(id, {.state = ReviewState::reviewed, .reviewer = "Anna"});
    });
  }
  [[nodiscard]] HandWork done() const { return handWork(history.steps, history.skeleton); }
};

TEST(Corrections, AreCountedByKind) {
  Work work;
  work.step(0, [](SkeletonEditor& editor) { addChild(editor, NodeId{2}, {2, 0, 3}); });
  work.step(0, [](SkeletonEditor& editor) { moveNode(editor, NodeId{3}, {9, 9, 9}); });
  work.step(0, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{4}, NodeId{0}); });
  work.step(0, [](SkeletonEditor& editor) { setEdgeType(editor, NodeId{3}, EdgeType::successor); });
  work.step(0, [](SkeletonEditor& editor) { editor.setRadius(NodeId{0}, 0.5); });
  work.step(0, [](SkeletonEditor& editor) { removeNode(editor, NodeId{5}); });
  work.step(0, [](SkeletonEditor& editor) { editor.setMarked(NodeId{0}, true); });
  work.reviewAll(0);
  const Corrections expected = {.edits = 6,
                                .added = 1,
                                .removed = 1,
                                .moved = 1,
                                .reparented = 1,
                                .retyped = 2, // the successor before branches now
                                .radii = 1};
  EXPECT_EQ(work.done().corrections, expected);
}

// To attach a branch to an edge puts a node there: what the edge led to grows from where it did.
TEST(Corrections, CountOnlyWhatIsAttachedElsewhere) {
  Work work;
  work.step(0, [](SkeletonEditor& editor) {
    const NodeId middle = splitEdge(editor, NodeId{1}, 0.5);
    reparentNode(editor, NodeId{4}, middle);
  });
  EXPECT_EQ(work.done().corrections.added, 1U);
  EXPECT_EQ(work.done().corrections.reparented, 1U);
  Work other;
  other.step(0, [](SkeletonEditor& editor) { removeNode(editor, NodeId{1}); });
  EXPECT_EQ(other.done().corrections.removed, 1U);
  EXPECT_EQ(other.done().corrections.reparented, 0U) << "its children grow from its parent";
}

TEST(Corrections, BeginAfterTheLastReconstruction) {
  Work work;
  work.step(0, [](SkeletonEditor& editor) { moveNode(editor, NodeId{3}, {9, 9, 9}); });
  work.step(minute, [](SkeletonEditor& editor) { replaceSkeleton(editor, test::stick(9)); });
  EXPECT_EQ(work.done(), HandWork());
  const NodeId top = work.history.skeleton.ids().back();
  work.step(3 * minute, [&](SkeletonEditor& editor) { removeNode(editor, top); });
  EXPECT_EQ(work.done().corrections, (Corrections{.edits = 1, .removed = 1}));
  EXPECT_EQ(work.done().time, 2 * minute) << "one looks at what was made before the first edit";
}

MadeByHand madeBy(const Work& work) {
  const auto stepAt = [&](std::size_t i) -> const HistoryStep& { return work.history.steps[i]; };
  return madeByHand(stepAt, work.history.position, work.history.skeleton);
}

TEST(MadeByHand, IsABranchThatWasDrawnAndNotTheNodeThatBearsIt) {
  Work work;
  NodeId middle{};
  NodeId first{};
  work.step(0, [&](SkeletonEditor& editor) {
    middle = splitEdge(editor, NodeId{1}, 0.5);
    first = addChild(editor, middle, {1, 1, 1});
    addChild(editor, first, {2, 2, 1});
  });
  const MadeByHand made = madeBy(work);
  EXPECT_EQ(std::ranges::count(made.isDrawn, true), 2);
  EXPECT_TRUE(made.isDrawn[indexOf(first)]);
  EXPECT_FALSE(made.isDrawn[indexOf(middle)]);
  EXPECT_EQ(std::ranges::count(made.isAttached, true), 0);
}

TEST(MadeByHand, IsNeitherWhatTakesTheWoodOfBeforeAwayNorManyBranchesAtOnce) {
  Work work;
  work.step(0, [](SkeletonEditor& editor) { // as a part that is reconstructed anew
    removeNode(editor, NodeId{4});
    addChild(editor, NodeId{1}, {1, 1, 1});
  });
  work.step(0, [](SkeletonEditor& editor) { // as branches that are taken all at once
    addChild(editor, NodeId{2}, {1, 1, 3});
    addChild(editor, NodeId{3}, {1, 2, 3});
  });
  work.step(0, [](SkeletonEditor& editor) {
    reparentNode(editor, NodeId{2}, NodeId{0});
    reparentNode(editor, NodeId{3}, NodeId{0});
  });
  const MadeByHand made = madeBy(work);
  EXPECT_EQ(std::ranges::count(made.isDrawn, true), 0);
  EXPECT_EQ(std::ranges::count(made.isAttached, true), 0);
}

TEST(MadeByHand, IsWhatWasAttachedElsewhereSinceTheLastReconstruction) {
  Work work;
  const auto attach = [&] {
    work.step(0, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{2}, NodeId{0}); });
  };
  attach();
  EXPECT_TRUE(madeBy(work).isAttached[2]);
  work.step(0, [](SkeletonEditor& editor) { replaceSkeleton(editor, test::stick(9)); });
  EXPECT_EQ(std::ranges::count(madeBy(work).isAttached, true), 0);
}

TEST(HandWork, LeavesOutLongPausesAndAClockThatWasSetBack) {
  Work work;
  double height = 1;
  const auto moveAt = [&](std::int64_t time) {
    work.step(time, [&](SkeletonEditor& editor) { moveNode(editor, NodeId{3}, {0, 0, ++height}); });
  };
  moveAt(0);
  moveAt(2 * minute);
  moveAt(2 * minute + longestPause); // just counts
  moveAt(100 * minute);              // after lunch
  moveAt(101 * minute);
  moveAt(50 * minute);
  moveAt(51 * minute);
  EXPECT_EQ(work.done().time, (2 + 5 + 1 + 1) * minute);
  EXPECT_EQ(handWork({}, Skeleton()), HandWork());
}

TEST(Seal, StatesWhoWhenAndWhatWasDone) {
  Work work;
  work.step(10 * minute, [](SkeletonEditor& editor) { moveNode(editor, NodeId{2}, {1, 0, 2.5}); });
  work.reviewAll(12 * minute);
  const Seal seal = signedBy("Anna", 13 * minute, work.history);
  EXPECT_EQ(seal.author, "Anna");
  EXPECT_EQ(seal.time, 13 * minute);
  EXPECT_EQ(seal.work.time, 2 * minute);
  EXPECT_EQ(seal.work.corrections.moved, 1U);
  EXPECT_EQ(seal.nodes, 5U);
  EXPECT_DOUBLE_EQ(seal.length, 1 + std::sqrt(1 + 1.5 * 1.5) + 2 * std::sqrt(2.0));
  EXPECT_EQ(seal.hash, StructureHash(work.history.skeleton).value());
}

TEST(Seal, LeavesOutWhatWasUndone) {
  Work work;
  work.reviewAll(0);
  const Seal before = signedBy("Anna", 0, work.history);
  work.step(minute, [](SkeletonEditor& editor) { moveNode(editor, NodeId{2}, {1, 0, 2.5}); });
  work.history.steps.back().delta.inverse().apply(work.history.skeleton);
  --work.history.position;
  EXPECT_EQ(signedBy("Anna", 0, work.history), before);
}

TEST(Seal, IsRefusedUnlessAllIsReviewedAndANameIsGiven) {
  const auto refusal = [](const std::string& author, const History& history) {
    return test::errorOf([&] { return signedBy(author, 0, history); });
  };
  Work work;
  EXPECT_THAT(refusal("Anna", work.history), HasSubstr("5 of 5 nodes are not reviewed"));
  work.reviewAll(0);
  EXPECT_THAT(refusal(" ", work.history), HasSubstr("type who signs"));
  work.step(0, [](SkeletonEditor& editor) { moveNode(editor, NodeId{2}, {9, 9, 9}); });
  EXPECT_THAT(refusal("Anna", work.history), HasSubstr("1 of 5 nodes"));
  EXPECT_THAT(refusal("Anna", {}), HasSubstr("no skeleton"));
}

TEST(Seal, ReadsBackFromItsText) {
  const Seal seal{.author = "Zoë \"Z\" O'Hara",
                  .time = 1'763'733'909'123,
                  .work = {{.edits = 1,
                            .added = 2,
                            .removed = 3,
                            .moved = 4,
                            .reparented = 5,
                            .retyped = 6,
                            .radii = 7},
                           987'654},
                  .nodes = 1204,
                  .length = 12.3456789,
                  .hash = 0x00fedcba98765432};
  EXPECT_EQ(sealFrom(textOf(seal)), seal) << "as an older program wrote it";
  EXPECT_THAT(textOf(seal), HasSubstr("\"2025-11-21T14:05:09Z\""));
  Seal whole = seal;
  whole.review = {.lookedAt = {100, 2.5},
                  .inBulk = {3, 0.5},
                  .before = {1, 0.25},
                  .doubted = {2, 0.125},
                  .comments = 4};
  whole.state = {.findings = {{"bare_twig", 7}, {"sharp_turn", 2}},
                 .ignored = 3,
                 .points = 148'000,
                 .unexplained = 1200,
                 .ignoredPlaces = 2,
                 .ignoredPoints = 90,
                 .questions = SealedQuestions{.answered = 14, .open = 3},
                 .automatic = SealedAgreement{"the reconstruction", 0.01, 0.9, 0.8, 0.85, 0.7},
                 .other = std::nullopt,
                 .reason = "dead twigs are \"no\" wood"};
  EXPECT_EQ(sealFrom(textOf(whole)), whole);
  EXPECT_EQ(whole.state->openFindings(), 9U);
  whole.state->questions->open.reset();
  EXPECT_EQ(sealFrom(textOf(whole)), whole);
  std::string older = textOf(whole); // whose program did not count them
  for (const char* line : {"ignored_places\": 2", "ignored_points\": 90", "questions\": {"}) {
    const std::size_t at = older.find(line);
    ASSERT_NE(at, std::string::npos);
    older.replace(at, 1, "x");
  }
  whole.state->ignoredPlaces = whole.state->ignoredPoints = 0;
  whole.state->questions.reset();
  EXPECT_EQ(sealFrom(older), whole);
}

TEST(Seal, StatesHowItWasReviewed) {
  Work work;
  work.reviewAll(0);
  const Seal seal = signedBy("Anna", 0, work.history, SealedState{.ignored = 1});
  EXPECT_EQ(seal.review, reviewRecord(work.history.steps, work.history.skeleton));
  EXPECT_EQ(seal.state, SealedState{.ignored = 1});
}

/// Turned, scaled and shifted as a whole, as where it is laid onto a scan.
void lay(SkeletonEditor& editor) {
  const Eigen::AngleAxisd turn(0.4, Eigen::Vector3d(1, 2, 3).normalized());
  for (const NodeId id : editor.skeleton().ids()) {
    const Eigen::Vector3d place = 2 * (turn * editor.skeleton()[id].position);
    editor.setPosition(id, place + Eigen::Vector3d(3e6, 4e6, 50));
  }
}

TEST(HandWork, CountsNoCorrectionWhereThePlantIsMovedAsAWhole) {
  Work work{.history = {.skeleton = test::fork(3)}};
  work.step(0, lay);
  EXPECT_EQ(work.done().corrections, Corrections());
  EXPECT_FALSE(beginningOfHandWork(work.history).skeleton.isEmpty());
  const Skeleton beginning = beginningOfHandWork(work.history).skeleton;
  for (const NodeId id : beginning.ids())
    EXPECT_LT((beginning[id].position - work.history.skeleton[id].position).norm(), 1e-6)
        << "an agreement with it is of what was corrected";
  work.step(0, [](SkeletonEditor& editor) { // one otherwise than all others
    lay(editor);
    const NodeId id = editor.skeleton().ids().back();
    editor.setPosition(id, editor.skeleton()[id].position + Eigen::Vector3d(0, 0, 1));
  });
  EXPECT_EQ(work.done().corrections.edits, 1U);
  EXPECT_EQ(work.done().corrections.moved, work.history.skeleton.size());
}

TEST(BeginningOfHandWork, OfAPlantThatIsDrawnFromNothingIsNothing) {
  Work work{.history = {}};
  work.step(0, [](SkeletonEditor& editor) { replaceSkeleton(editor, test::stick(4)); });
  EXPECT_TRUE(beginningOfHandWork(work.history).skeleton.isEmpty());
  EXPECT_FALSE(beginningOfHandWork(work.history).isReconstructed);
  EXPECT_EQ(work.done().corrections.added, 4U) << "a first stroke is work by hand";
  work.history.steps.back().replacesContracted = true; // as a reconstruction does
  EXPECT_EQ(beginningOfHandWork(work.history).skeleton.size(), 4U);
  EXPECT_TRUE(beginningOfHandWork(work.history).isReconstructed);
}

TEST(BeginningOfHandWork, IsWhatTheLastReconstructionMadeOrWhatWasOpened) {
  Work work;
  const Skeleton opened = work.history.skeleton;
  work.step(0, [](SkeletonEditor& editor) { moveNode(editor, NodeId{3}, {9, 9, 9}); });
  EXPECT_EQ(beginningOfHandWork(work.history).skeleton, opened);
  EXPECT_FALSE(beginningOfHandWork(work.history).isReconstructed);
  work.step(0, [](SkeletonEditor& editor) { replaceSkeleton(editor, test::stick(9)); });
  const Skeleton reconstructed = work.history.skeleton;
  work.step(0, [&](SkeletonEditor& editor) { removeNode(editor, editor.skeleton().ids().back()); });
  EXPECT_EQ(beginningOfHandWork(work.history).skeleton, reconstructed);
  EXPECT_TRUE(beginningOfHandWork(work.history).isReconstructed);
}

TEST(Seal, OfAnyOtherTextIsAnError) {
  const std::string text = textOf({.author = "Anna"});
  for (std::size_t size = 0; size + 2 < text.size(); ++size)
    EXPECT_THROW((void)sealFrom(text.substr(0, size)), Error) << size;
  EXPECT_THROW((void)sealFrom("[]"), Error);
  EXPECT_THROW((void)sealFrom(R"({"format": "espalier seal 1", "signed_by": 3})"), Error);
  std::string badHash = text;
  badHash.replace(badHash.find("0000000000000000"), 16, "000000000000000g");
  EXPECT_THROW((void)sealFrom(badHash), Error);
}

TEST(StructureHash, FollowsEveryEditUndoAndRedo) {
  test::EditsAtRandom edits({.skeleton = test::randomPlant(30, 4)}, 4);
  for (int act = 0; act < 300; ++act) {
    StructureHash hash(edits.history().skeleton);
    const std::size_t position = edits.history().position;
    const auto next = edits.next();
    const bool isUndo = next.added.empty() && next.position < position;
    const bool isRedo = next.added.empty() && next.position > position;
    if (isUndo) hash.apply(edits.history().steps[next.position].delta.inverse());
    if (isRedo) hash.apply(edits.history().steps[position].delta);
    if (isUndo || isRedo) {
      EXPECT_EQ(hash.value(), StructureHash(edits.history().skeleton).value());
    }
  }
}

TEST(StructureHash, DiffersByWhateverIsSigned) {
  const Skeleton plant = test::fork(3);
  const auto hashAfter = [&](const std::function<void(Skeleton&)>& change) {
    Skeleton changed = plant;
    change(changed);
    return StructureHash(changed).value();
  };
  const std::uint64_t hash = StructureHash(plant).value();
  EXPECT_EQ(hashAfter([](Skeleton&) {}), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.setPosition(NodeId{3}, {0, 0, 2}); }), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.setRadius(NodeId{3}, 0.2); }), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.setEdge(NodeId{3}, EdgeType::successor); }), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.reparent(NodeId{3}, NodeId{0}, EdgeType::branching); }),
            hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.erase(NodeId{3}); }), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.add({.parent = NodeId{3}}); }), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) { s.setEntities(NodeId{3}, {{.symbol = "U"}}); }), hash);
  EXPECT_NE(hashAfter([](Skeleton& s) {
              s.setReview(NodeId{3}, {ReviewState::doubtful, {}, {}});
            }),
            hash);
  EXPECT_EQ(hashAfter([](Skeleton& s) { s.setReview(NodeId{3}, {.comment = "a remark"}); }), hash);
  EXPECT_EQ(hashAfter([](Skeleton& s) { s.setMarked(NodeId{3}, true); }), hash);
}

} // namespace
} // namespace espalier
