package org.selectiverenderer.authoring.enrichment;

import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.base.problem.ProblemCollector;

/** Tables of metadata and of ratings, for an author's scene. */
public final class MetadataTableFuzzTarget {
  private MetadataTableFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    MetadataTable.edit(
        EnrichmentScenes.with("<Switch DEF='Switch_A'><Shape/><Shape/></Switch>").enrichment,
        "fuzz.csv",
        input,
        new ProblemCollector());
    Ratings.read("fuzz.csv", input, new ProblemCollector());
  }
}
