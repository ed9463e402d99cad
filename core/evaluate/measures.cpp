#include "core/base/shown.h"
#include "core/evaluate/scores.h"

namespace espalier {

const std::vector<Measure>& measures() {
  using Group = ScoreGroup;
  static const std::vector<Measure> all = {
      {Shown::tr("Registration"),
       Shown::tr("The plant is moved to where it fits the reference best, from several starts, "
                 "before anything is measured: two files of one plant are often not in the same "
                 "frame. It is turned only where that lowers the mean distance by a tenth."),
       "P. Besl, N. McKay, A method for registration of 3-D shapes, PAMI 14(2), 1992.",
       Group::nearness},
      {Shown::tr("Precision, recall, F"),
       Shown::tr("Shares of the length of the plant near the reference, and of the reference near "
                 "the plant, and their harmonic mean; places are sampled at even steps, distances "
                 "taken to edges."),
       "A. Knapitsch et al., Tanks and Temples, ACM Transactions on Graphics 36(4), 2017.",
       Group::nearness},
      {Shown::tr("Missed, invented, wrongly attached"),
       Shown::tr(
           "Stretches without anything of the other within the tolerance; and what lies right but "
           "is attached to wood that meets its own more than four tolerances farther down."),
       "This program.", Group::nearness},
      {Shown::tr("Distances"), "",
       "Chamfer and Hausdorff distances; substantial distances as in tools for neurons.",
       Group::nearness},
      {Shown::tr("G, T and mapping"),
       Shown::tr("Unbranched segments are matched one to one at the least sum of Hausdorff "
                 "distances; G is the share of length matched, T that of matches that are attached "
                 "to matches. Both hardly fall with noise."),
       "F. Boudon et al., Annals of Botany 114, 2014; C. Preuksakarn, thesis, Montpellier, 2012.",
       Group::segments},
      {Shown::tr("Capped, over all, one to many"),
       Shown::tr(
           "The same with nothing hidden: matches lie within the distance as curves, T counts all "
           "segments of the reference, and a branch may match the pieces that spurs cut it into."),
       "This program, after the same.", Group::segments},
      {Shown::tr("Landmarks"), "", "This program.", Group::landmarks},
      {Shown::tr("DIADEM-like score"),
       Shown::tr("Share of tips and branchings that are found and reached along a path as long, "
                 "from the next one below that is found; invented ones count against it."),
       "T. Gillette, K. Brown, G. Ascoli, Neuroinformatics 9, 2011.", Group::landmarks},
      {Shown::tr("NetMets"),
       Shown::tr(
           "Shares of length that the other plant lacks, by a Gaussian of the distance; and of the "
           "paths between tips and branchings that both have, those that only one has."),
       "D. Mayerich et al., BMC Bioinformatics 13, 2012.", Group::network},
      {Shown::tr("Barcodes (TMD)"),
       Shown::tr("Each tip is a bar, from where it leaves something longer up to its end, along "
                 "the plant; 0 where all bars are alike, 1 where none is."),
       "L. Kanari et al., Neuroinformatics 16, 2018.", Group::network},
      {Shown::tr("Orders, axes, edges"), "", "This program.", Group::architecture},
      {Shown::tr("Kappa"),
       Shown::tr("Agreement on what continues an axis and what branches, at the feet of matched "
                 "segments, beyond what chance would do."),
       "J. Cohen, Educational and Psychological Measurement 20, 1960.", Group::architecture},
      {Shown::tr("Edit distance"),
       Shown::tr(
           "The least that has to be removed and inserted to make one tree of the other, where "
           "what is attached to what must stay; similarity 1 where nothing is to be done."),
       "K. Zhang, Algorithmica 15, 1996; P. Ferraro, C. Godin, Annals of Forest Science 57, 2000.",
       Group::edits},
      {Shown::tr("Radii"), "", "This program.", Group::radii},
      {Shown::tr("Concordance"),
       Shown::tr("Agreement of radii where both plants lie near each other: 1 where all are the "
                 "same. Unlike a correlation it falls where all are too large alike."),
       "L. Lin, Biometrics 45, 1989.", Group::radii},
      {Shown::tr("Breast height, and the circumference"),
       Shown::tr("Stems are measured 1.3 m above the foot of the reference. Of 16 sectors about a "
                 "node of the reference, those that hold points of its section are the share of "
                 "the circumference the scanner saw."),
       "P. Raumonen et al., Remote Sensing 5, 2013, for the sectors.", Group::radii}};
  return all;
}

} // namespace espalier
