package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.report.ReportBlock.Items;
import org.selectiverenderer.statistics.report.ReportBlock.Paragraph;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Builds the section on missing data: rows of the file that are left out, and participants whose
 * usable answers give no score at a level of confidence.
 */
final class MissingDataSection {
  private MissingDataSection() {}

  /** The number of participants of an area and confidence level without a score. */
  record Gap(String area, ConfidenceThreshold level, int without, int participants) {
    String sentence() {
      return "%s, %s: %d of %d.".formatted(area, level.title(), without, participants);
    }
  }

  /** Returns the blocks about rows, then those about participants. */
  static List<ReportBlock> of(StudyAnalysis study) {
    List<ReportBlock> blocks = new ArrayList<>();
    List<Exclusion> exclusions = study.responses().exclusions();
    blocks.add(
        exclusions.isEmpty()
            ? new Paragraph("Rows: none is left out; every answer of the file is used.")
            : AnovaReport.exclusions(exclusions));
    List<Gap> gaps = gaps(study);
    if (gaps.isEmpty()) {
      blocks.add(new Paragraph("Participants: each has every score."));
    } else {
      blocks.add(
          new Paragraph(
              "Participants without a score, who are left out of its analyses; the notes below an"
                  + " area's effects name them:"));
      blocks.add(new Items(gaps.stream().map(Gap::sentence).toList()));
    }
    return blocks;
  }

  /** Returns the gaps of d'; participants without d' have no other score either. */
  static List<Gap> gaps(StudyAnalysis study) {
    int all = study.participants().size();
    List<Gap> gaps = new ArrayList<>();
    for (AreaAnalysis analysis : study.analyses()) {
      int n = analysis.design().subjects().size();
      if (analysis.measure() == DetectionMeasure.D_PRIME && n < all) {
        gaps.add(new Gap(analysis.area(), analysis.level(), all - n, all));
      }
    }
    return gaps;
  }
}
