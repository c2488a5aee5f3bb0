package org.selectiverenderer.authoring.headless;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits;
import org.selectiverenderer.authoring.enrichment.MetadataTable;
import org.selectiverenderer.authoring.file.BrokenRelativeUrls;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.file.UnifiedDiff;
import org.selectiverenderer.authoring.file.XmlConversion;
import org.selectiverenderer.authoring.ratings.GazeProposal;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.authoring.ratings.RatingPlan;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.authoring.ratings.ViewedObjects;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentError;

/**
 * Enriches a scene from tables, without a window: first from expectancy ratings, or from what
 * participants looked at, then from a table of metadata.
 */
public final class HeadlessEnrichment {
  private final DocumentFile file;
  private final String before;
  private final DocumentEnrichment enrichment;
  private final ProblemCollector problems;
  private List<GazeProposal> proposals = List.of();

  private HeadlessEnrichment(
      DocumentFile file, NodeCatalogue catalogue, ProblemCollector problems) {
    this.file = file;
    this.before = file.document().snapshot().text();
    this.enrichment = new DocumentEnrichment(file.document(), catalogue);
    this.problems = problems;
  }

  /**
   * The input and output files of an enrichment.
   *
   * @param ratings RATINGS.csv, or null
   * @param scale how its ratings choose among versions
   * @param metadata METADATA.csv, or null
   * @param gaze proposals from head logs, or null; with them, ratings are not written themselves
   *     but are what the proposals are shrunk towards
   * @param output the file to be written: the scene itself, or another
   */
  public record Request(
      Path scene,
      @Nullable Path ratings,
      RatingScale scale,
      @Nullable Path metadata,
      @Nullable GazeProposalSource gaze,
      Path output) {
    /** Makes a request without head logs, in which ratings count by the thesis's bands. */
    public Request(Path scene, @Nullable Path ratings, @Nullable Path metadata, Path output) {
      this(scene, ratings, RatingScale.BANDS, metadata, null, output);
    }
  }

  /** Makes proposals from head logs. */
  @FunctionalInterface
  public interface GazeProposalSource {
    /**
     * @param objects finds what the logs name in the scene
     * @param problems receives what is wrong with the logs
     * @throws IOException if a log cannot be read, with a one-line message that names it
     */
    List<GazeProposal> of(ViewedObjects objects, ProblemCollector problems) throws IOException;
  }

  /**
   * Enriches a scene in memory.
   *
   * @return empty if the scene or a table has errors, which are reported
   * @throws IOException if a file cannot be read, with a one-line message that names it
   */
  public static Optional<HeadlessEnrichment> of(
      Request request, NodeCatalogue catalogue, ProblemCollector problems) throws IOException {
    Optional<DocumentFile> opened =
        XmlConversion.open(
            request.scene(), request.output(), "metadata is written", catalogue, problems);
    if (opened.isEmpty()) {
      return Optional.empty();
    }
    HeadlessEnrichment run = new HeadlessEnrichment(opened.get(), catalogue, problems);
    SceneDocument document = run.file.document();
    Optional<DocumentError> fault = document.fault();
    if (fault.isPresent()) {
      problems.error(fault.get().location(), fault.get().message() + "; nothing has been changed");
      return Optional.empty();
    }
    boolean done =
        (request.gaze() != null
                ? run.gaze(request.gaze(), request.ratings(), request.scale())
                : request.ratings() == null || run.ratings(request.ratings(), request.scale()))
            && (request.metadata() == null || run.metadata(request.metadata()));
    return done ? Optional.of(run) : Optional.empty();
  }

  private boolean ratings(Path table, RatingScale scale) throws IOException {
    Optional<Ratings> ratings = Ratings.read(table.toString(), read(table), problems);
    if (ratings.isEmpty()) {
      return false;
    }
    ObjectNameMatcher matching =
        new ObjectNameMatcher(ratings.get().means().keySet(), enrichment.switches());
    RatingPlan plan = RatingPlan.of(enrichment, ratings.get(), matching, true, scale);
    plan.unused().forEach(match -> unused(table, match));
    String following =
        plan.rows().stream()
            .filter(row -> row.object().isEmpty())
            .map(row -> row.node().name())
            .collect(Collectors.joining(", "));
    if (!following.isEmpty()) {
      problems.info(
          SourceLocation.of(table.toString()),
          "objects without ratings, taken as expected in their room: " + following);
    }
    String silent =
        plan.unrated().stream().map(EnrichedSwitch::name).collect(Collectors.joining(", "));
    if (!silent.isEmpty()) {
      problems.info(
          SourceLocation.of(table.toString()),
          "objects without ratings, which get no metadata: " + silent);
    }
    return perform(plan.edit("Import ratings"));
  }

  private boolean gaze(GazeProposalSource source, @Nullable Path table, RatingScale scale)
      throws IOException {
    Ratings prior = new Ratings(Map.of());
    if (table != null) {
      Optional<Ratings> read = Ratings.read(table.toString(), read(table), problems);
      if (read.isEmpty()) {
        return false;
      }
      prior = read.get();
    }
    ObjectNameMatcher matching =
        new ObjectNameMatcher(prior.means().keySet(), enrichment.switches());
    if (table != null) {
      matching.matches().stream()
          .filter(match -> !match.counts())
          .forEach(match -> unused(table, match));
    }
    ViewedObjects objects = new ViewedObjects(enrichment, prior, matching);
    proposals = List.copyOf(source.of(objects, problems));
    Ratings accepted = ViewedObjects.of(enrichment).with(new Ratings(Map.of()), proposals, scale);
    Set<String> names = accepted.means().keySet();
    ObjectNameMatcher switches = new ObjectNameMatcher(names, enrichment.switches());
    names.forEach(name -> switches.choose(name, name));
    if (names.isEmpty()) {
      return true;
    }
    RatingPlan plan =
        RatingPlan.of(enrichment, accepted, objects.places(proposals), switches, false, scale);
    plan.sensors().stream().filter(area -> area.schemas().exit().isEmpty()).forEach(this::noExit);
    return perform(plan.edit("Consistency from gaze"));
  }

  private void noExit(EnrichmentEdits.SensorMetadata area) {
    problems.info(
        SourceLocation.of(file.document().name()),
        ("%s gets no exit schema, since none of its objects was seen or rated in a room around it;"
                + " objects do not change back when the viewer leaves")
            .formatted(area.node().name()));
  }

  /** Returns the proposals from head logs, those that were not clear enough to write included. */
  public List<GazeProposal> proposals() {
    return proposals;
  }

  private void unused(Path table, Match match) {
    problems.warning(
        SourceLocation.of(table.toString()),
        match.counts()
            ? "'%s' is %s, which has no versions or was rated under another name; not used"
                .formatted(match.object(), match.switchName().orElse(""))
            : "no Switch of the scene has the name '%s'%s; its ratings are not used"
                .formatted(
                    match.object(),
                    match.switchName().map(name -> "; is " + name + " meant?").orElse("")));
  }

  private boolean metadata(Path table) throws IOException {
    return MetadataTable.edit(enrichment, table.toString(), read(table), problems)
        .filter(this::perform)
        .isPresent();
  }

  private boolean perform(Edit edit) {
    try {
      file.document().perform(edit);
      return true;
    } catch (EditRejectedException e) {
      problems.error(SourceLocation.of(file.document().name()), e.getMessage());
      return false;
    }
  }

  private static byte[] read(Path table) throws IOException {
    try {
      return InputFileReader.bytes(table);
    } catch (NoSuchFileException e) {
      throw new IOException(table + ": the file does not exist", e);
    } catch (AccessDeniedException e) {
      throw new IOException(table + ": no permission to read the file", e);
    }
  }

  /** Returns whether the scene differs from its file. */
  public boolean changed() {
    return !before.contentEquals(file.document().text());
  }

  /** Returns the difference to the scene's file as a unified diff. */
  public String difference(Path output) {
    return UnifiedDiff.of(
        file.path().toString(), output.toString(), before, file.document().text().toString());
  }

  /** Returns the relative URLs of files that the scene would not find from the output's folder. */
  public List<String> leftBehind(Path output) {
    return BrokenRelativeUrls.in(
        file.document(),
        file.path().toAbsolutePath().getParent(),
        output.toAbsolutePath().getParent());
  }

  /**
   * Writes the scene, to its own file with a backup, or to another one.
   *
   * @throws IOException if it cannot be written, with a one-line message that names it
   */
  public void save(Path output) throws IOException {
    if (output.equals(file.path())) {
      file.save();
    } else {
      file.saveAs(output);
    }
  }
}
