package org.selectiverenderer.enricher.ratings;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.authoring.ratings.GazeProposal;
import org.selectiverenderer.authoring.ratings.ViewedObjects;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.gaze.ConsistencyEstimate;
import org.selectiverenderer.study.gaze.ConsistencyEstimator;
import org.selectiverenderer.study.gaze.GazeArea;
import org.selectiverenderer.study.gaze.ViewingData;

/** Proposes consistency for the objects of a scene from the head logs of participants. */
public final class GazeProposals {
  private final ViewingData data;

  private GazeProposals(ViewingData data) {
    this.data = data;
  }

  /**
   * Reads head logs, which may take seconds.
   *
   * @param logs files, and folders of sessions or studies
   * @param scene file name of the scene
   * @param problems receives what is wrong with the logs
   * @throws IOException if a path cannot be read, with a one-line message that names it
   */
  public static GazeProposals read(List<Path> logs, String scene, ProblemCollector problems)
      throws IOException {
    ViewingData data = ViewingData.read(logs, scene, problems);
    if (data.participants() == 1) {
      problems.info(
          SourceLocation.of(logs.get(0).toString()),
          "one participant only: nothing is proposed from one person's interests; name the logs of"
              + " others too (each folder sub-ID is a participant, else each file)");
    }
    String varied =
        data.conditions().stream()
            .filter(name -> !name.isEmpty() && !name.equals(Condition.HIGH.spelling()))
            .collect(Collectors.joining(", "));
    if (!varied.isEmpty()) {
      problems.info(
          SourceLocation.of(logs.get(0).toString()),
          "recorded under the condition %s: versions with fewer polygons may draw less attention; "
                  .formatted(varied)
              + "logs of the condition high do not have this doubt");
    }
    return new GazeProposals(data);
  }

  /** Returns the number of participants whose logs are used. */
  public int participants() {
    return data.participants();
  }

  /** Returns the proposals, by schema, the most inconsistent objects first. */
  public List<GazeProposal> of(ViewedObjects objects) {
    ViewingData bySchema =
        data.named(area -> new GazeArea(objects.schema(area.name(), area.schema()), true));
    return ConsistencyEstimator.of(bySchema, (object, area) -> objects.rating(object, area.name()))
        .stream()
        .map(estimate -> proposal(estimate, objects))
        .toList();
  }

  private static GazeProposal proposal(ConsistencyEstimate estimate, ViewedObjects objects) {
    ConsistencyEstimate.Evidence evidence = estimate.evidence();
    return new GazeProposal(
        estimate.object(),
        estimate.area().name(),
        estimate.rating(),
        estimate.degree(),
        estimate.low(),
        estimate.high(),
        estimate.type(),
        new GazeProposal.Evidence(
            evidence.participants(), evidence.inView(), evidence.dwell(), evidence.fixations()),
        objects.versions(estimate.object()));
  }
}
