package org.selectiverenderer.enricher.ratings;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.ratings.GazeProposal;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.authoring.ratings.RatingPlan;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.authoring.ratings.ViewedObjects;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The model of a ratings import under review: the table that was read, the Switch of each object,
 * and the implied metadata, which follows each correction at once. Not thread-safe.
 */
final class RatingsImportModel {
  /**
   * The result of reading head logs.
   *
   * @param objects what the proposals rest on beside the logs
   */
  record Logs(
      GazeProposals read,
      ViewedObjects objects,
      List<GazeProposal> proposals,
      List<Problem> problems) {}

  /** The result of reading a table. */
  record Table(String name, Optional<Ratings> ratings, List<Problem> problems) {}

  private final DocumentEnrichment enrichment;
  private final List<Runnable> listeners = new ArrayList<>();
  private List<Problem> ofTable = List.of();
  private List<Problem> ofLogs = List.of();
  private String name = "";
  private @Nullable Ratings ratings;
  private @Nullable ObjectNameMatcher matching;
  private @Nullable RatingPlan plan;

  /** The objects with the ratings of the table; null after a change of either. */
  private @Nullable ViewedObjects viewed;

  private boolean unratedFollow = true;
  private RatingScale scale = RatingScale.BANDS;
  private final GazeImport gaze = new GazeImport();
  private boolean gazeStale;

  RatingsImportModel(DocumentEnrichment enrichment) {
    this.enrichment = enrichment;
  }

  /** Reads a table; thread-safe. */
  static Table read(String name, byte[] table) {
    ProblemCollector problems = new ProblemCollector();
    return new Table(name, Ratings.read(name, table, problems), problems.list());
  }

  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Uses a table that was read; of one with errors only the problems are listed. */
  void take(Table table) {
    name = table.name();
    ofTable = table.problems();
    ratings = table.ratings().orElse(null);
    matching =
        ratings == null
            ? null
            : new ObjectNameMatcher(ratings.means().keySet(), enrichment.switches());
    rematched();
  }

  private void rematched() {
    viewed = null;
    gazeStale = gaze.logs() != null;
    work();
  }

  /** What logs name in the scene as it is now, with the ratings of the table. */
  ViewedObjects viewed() {
    ViewedObjects objects = viewed;
    if (objects == null) {
      objects =
          ratings == null || matching == null
              ? ViewedObjects.of(enrichment)
              : new ViewedObjects(enrichment, ratings, matching);
      viewed = objects;
    }
    return objects;
  }

  /** Reads head logs and makes proposals; thread-safe. */
  static Logs read(List<Path> logs, String scene, ViewedObjects objects) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    GazeProposals read = GazeProposals.read(logs, scene, problems);
    return new Logs(read, objects, read.of(objects), problems.list());
  }

  /** Uses logs that were read. */
  void take(Logs logs) {
    ofLogs = logs.problems();
    take(logs.read(), logs.objects(), logs.proposals());
  }

  /**
   * Uses new proposals from the logs that were read.
   *
   * @param objects what they rest on beside the logs, which another table may have changed since
   */
  void take(GazeProposals read, ViewedObjects objects, List<GazeProposal> proposals) {
    gaze.take(read, proposals);
    gazeStale = objects != viewed();
    work();
  }

  GazeImport gaze() {
    return gaze;
  }

  /** Whether the ratings have changed since the proposals were made; false after it was asked. */
  boolean takeGazeStale() {
    boolean stale = gazeStale;
    gazeStale = false;
    return stale;
  }

  /** Accepts a proposal from the logs, or takes that back. */
  void accept(GazeProposal proposal, boolean accept) {
    gaze.accept(proposal, accept);
    work();
  }

  /** Lists why logs could not be read. */
  void unreadLogs(Problem problem) {
    ofLogs = List.of(problem);
    listeners.forEach(Runnable::run);
  }

  /** Sets whether objects without ratings are treated as expected in their room. */
  void unratedFollow(boolean follow) {
    unratedFollow = follow;
    work();
  }

  RatingScale scale() {
    return scale;
  }

  /** Sets how ratings choose among versions. */
  void scale(RatingScale chosen) {
    scale = chosen;
    work();
  }

  /** Assigns a Switch to an object of the table; empty for none. */
  void match(String object, Optional<String> switchName) {
    ObjectNameMatcher current = matching;
    if (current != null) {
      switchName.ifPresentOrElse(
          name -> current.choose(object, name), () -> current.leaveOut(object));
      rematched();
    }
  }

  /** Accepts all proposed Switches, whose names are only similar. */
  void acceptProposals() {
    ObjectNameMatcher current = matching;
    if (current != null) {
      current.matches().stream()
          .filter(match -> match.how() == ObjectNameMatcher.How.PROPOSED)
          .forEach(match -> current.choose(match.object(), match.switchName().orElseThrow()));
      rematched();
    }
  }

  /** Computes the plan again, as after an edit of the document. */
  void work() {
    Ratings table = ratings;
    if (table == null && gaze.chosen().isEmpty()) {
      plan = null;
    } else {
      Ratings all = gaze.onto(table == null ? new Ratings(Map.of()) : table, viewed(), scale);
      plan =
          RatingPlan.of(
              enrichment,
              all,
              GazeImport.matching(all, matching, enrichment),
              unratedFollow && table != null,
              scale);
    }
    listeners.forEach(Runnable::run);
  }

  List<Match> matches() {
    return matching == null ? List.of() : matching.matches();
  }

  /** The names of the Switches that an object can be: those with at least two versions. */
  List<String> candidates() {
    return enrichment.switches().stream()
        .filter(node -> node.choices().size() > 1)
        .map(EnrichedSwitch::name)
        .distinct()
        .sorted(String.CASE_INSENSITIVE_ORDER)
        .toList();
  }

  Optional<RatingPlan> plan() {
    return Optional.ofNullable(plan);
  }

  /** The problems of the table, then those of the logs. */
  List<Problem> problems() {
    return Stream.concat(ofTable.stream(), ofLogs.stream()).toList();
  }

  /** One sentence for each thing left out: ratings not used, proposals, objects not rated. */
  List<String> leftOut() {
    if (plan == null) {
      return List.of();
    }
    Map<String, String> taken = new LinkedHashMap<>();
    plan.rows().forEach(row -> row.object().ifPresent(o -> taken.put(row.node().name(), o)));
    List<String> sentences = new ArrayList<>();
    for (Match match : plan.unused()) {
      sentences.add(Texts.of("ratings.unused", reason(match, taken)));
    }
    for (EnrichedSwitch node : plan.unrated()) {
      sentences.add(Texts.of("ratings.unrated", node.name()));
    }
    return sentences;
  }

  private static String reason(Match match, Map<String, String> taken) {
    String switchName = match.switchName().orElse("");
    return switch (match.how()) {
      case NONE -> Texts.of("ratings.noswitch", match.object());
      case PROPOSED -> Texts.of("ratings.maybe", match.object(), switchName);
      case SAME_NAME, CHOSEN ->
          taken.containsKey(switchName)
              ? Texts.of("ratings.already", match.object(), switchName, taken.get(switchName))
              : Texts.of("ratings.toofew", match.object(), switchName);
    };
  }

  /** A sentence that summarizes the import. */
  String summary() {
    if (!gaze.proposals().isEmpty() && ratings == null) {
      return Texts.of(
          "ratings.summary.gaze",
          DecimalFormatter.grouped(gaze.proposals().size()),
          DecimalFormatter.grouped(
              gaze.proposals().stream().filter(GazeProposal::applicable).count()),
          DecimalFormatter.grouped(gaze.chosen().size()));
    }
    if (plan == null) {
      return name.isEmpty() ? Texts.of("ratings.choose") : Texts.of("ratings.notused");
    }
    long proposed =
        matches().stream().filter(m -> m.how() == ObjectNameMatcher.How.PROPOSED).count();
    return Texts.of(
        "ratings.summary",
        DecimalFormatter.grouped(plan.rows().size()),
        DecimalFormatter.grouped(plan.sensors().size()),
        DecimalFormatter.grouped(plan.unused().size()),
        DecimalFormatter.grouped(matches().size()),
        proposed,
        DecimalFormatter.grouped(proposed));
  }

  /** Whether there is something to apply. */
  boolean applicable() {
    return plan != null && !(plan.rows().isEmpty() && plan.sensors().isEmpty());
  }

  /** The edit that applies the plan as one undo step; empty if there is nothing to apply. */
  Optional<Edit> edit() {
    viewed = null; // The scene may have been edited since the plan was computed.
    work();
    String step = ratings == null ? Texts.of("ratings.step.gaze") : Texts.of("ratings.step", name);
    return plan().filter(p -> applicable()).map(p -> p.edit(step));
  }
}
