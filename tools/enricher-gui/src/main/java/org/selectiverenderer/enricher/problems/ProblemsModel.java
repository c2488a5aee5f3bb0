package org.selectiverenderer.enricher.problems;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.geometry.GeometryRepair;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.problems.ProblemEntry.Place;
import org.selectiverenderer.enricher.text.AccessHint;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentError;

/**
 * The problems of a document: those known at once (not well formed, findings about the metadata),
 * and the results of the last checks, as long as their elements are in the document. In document
 * order. Has no widgets.
 */
final class ProblemsModel {
  /** Rules by which {@code validate} reports objects and areas without metadata. */
  private static final Set<String> NOT_ENRICHED = Set.of("SR403", "SR424", "SR426");

  private final SceneDocument document;
  private final DocumentEnrichment enrichment;
  private List<ProblemEntry> checked = List.of();
  private List<ProblemEntry> all = List.of();
  private Set<DocumentElement> faulty = Set.of();
  private int unenriched;
  private int enrichable;

  ProblemsModel(SceneDocument document, DocumentEnrichment enrichment) {
    this.document = document;
    this.enrichment = enrichment;
  }

  /**
   * Takes the results of the checks.
   *
   * @param revision the checked revision; results of an older one are ignored
   */
  void checked(long revision, List<Problem> problems) {
    if (revision == document.revision()) {
      checked = problems.stream().map(this::entry).toList();
    }
  }

  private ProblemEntry entry(Problem problem) {
    boolean here = problem.location().file().equals(document.name());
    Place place = here ? place(problem) : new Place.Elsewhere(problem.location());
    ProblemEntry found =
        new ProblemEntry(
            problem.severity(), AccessHint.inWindow(problem.message()), place, Optional.empty());
    return here ? found.with(repair(found)) : found;
  }

  /** Returns the repair of faulty geometry. */
  private Optional<ElementFinding.Fix> repair(ProblemEntry entry) {
    return entry
        .element()
        .flatMap(
            element ->
                entry
                    .rule()
                    .flatMap(rule -> GeometryRepair.of(rule, element))
                    .map(
                        kind ->
                            new ElementFinding.Fix(
                                Texts.of(
                                    switch (kind) {
                                      case NORMALIZE -> "problems.normalize";
                                      case REMOVE_EMPTY_FACES -> "problems.emptyfaces";
                                      case WELD -> "problems.weld";
                                      case WELD_ALL -> "problems.weldall";
                                    }),
                                () -> new GeometryRepair(document).edit(kind, element))));
  }

  private Place place(Problem problem) {
    if (problem.location().line() == 0) {
      return document
          .tree()
          .<Place>map(tree -> new Place.InElement(tree.root(), 0, tree.root().changed()))
          .orElse(new Place.InText(0));
    }
    int line = problem.location().line();
    int offset = document.offset(line, Math.max(1, problem.location().column()));
    Optional<DocumentElement> element = document.tree().flatMap(tree -> tree.at(offset));
    return element
        .<Place>map(in -> new Place.InElement(in, offset - in.start(), in.changed()))
        .orElse(new Place.InText(offset));
  }

  /** Updates the list from the present document. */
  void refresh() {
    List<ProblemEntry> now = new ArrayList<>();
    document.fault().map(this::entry).ifPresent(now::add);
    boolean wellFormed = document.tree().isPresent();
    if (wellFormed) {
      Map<Object, List<Integer>> known = new HashMap<>();
      enrichment.findings().forEach(finding -> add(ProblemEntry.of(finding), known, now));
      checked.stream()
          .filter(entry -> entry.current() && !onlyToBeDone(entry))
          .forEach(entry -> add(entry, known, now));
    }
    count(wellFormed);
    now.sort(
        Comparator.comparing(ProblemEntry::severity)
            .thenComparingInt(entry -> entry.offset().orElse(Integer.MAX_VALUE))
            .thenComparing(ProblemEntry::message));
    all = List.copyOf(now);
    faulty = Collections.newSetFromMap(new IdentityHashMap<>());
    all.stream()
        .filter(entry -> entry.severity() != Problem.Severity.INFO)
        .flatMap(
            entry ->
                entry.element().stream()
                    .filter(
                        element ->
                            entry.severity() == Problem.Severity.ERROR || !untouched(element)))
        .forEach(faulty::add);
  }

  /** Whether an entry only reports that its object or area is not enriched yet. */
  private boolean onlyToBeDone(ProblemEntry entry) {
    return entry.severity() != Problem.Severity.ERROR
        && entry.rule().filter(NOT_ENRICHED::contains).isPresent()
        && entry.element().filter(this::untouched).isPresent();
  }

  private void count(boolean wellFormed) {
    unenriched = 0;
    enrichable = 0;
    if (wellFormed) {
      enrichable = enrichment.switches().size() + enrichment.sensors().size();
      unenriched =
          (int)
              (enrichment.switches().stream().filter(node -> untouched(node.element())).count()
                  + enrichment.sensors().stream()
                      .filter(node -> untouched(node.element()))
                      .count());
    }
  }

  /**
   * Adds an entry, unless one that reports the same is listed, which then takes the worse severity.
   */
  private static void add(
      ProblemEntry entry, Map<Object, List<Integer>> known, List<ProblemEntry> now) {
    List<Integer> others = known.computeIfAbsent(key(entry), k -> new ArrayList<>());
    for (int index : others) {
      ProblemEntry other = now.get(index);
      if (entry.repeats(other)) {
        now.set(index, other.atLeast(entry.severity()));
        return;
      }
    }
    others.add(now.size());
    now.add(entry);
  }

  private ProblemEntry entry(DocumentError fault) {
    SourceLocation at = fault.location();
    int offset = document.offset(at.line(), Math.max(1, at.column()));
    return new ProblemEntry(
        Problem.Severity.ERROR, fault.message(), new Place.InText(offset), Optional.empty());
  }

  private static Object key(ProblemEntry entry) {
    return entry.element().<Object>map(element -> element).orElse(entry.place());
  }

  /** Whether an element is an object or an area without metadata and findings. */
  private boolean untouched(DocumentElement element) {
    return enrichment
            .switchNode(element)
            .filter(
                node -> !node.enriched() && node.qualities().isEmpty() && node.findings().isEmpty())
            .isPresent()
        || enrichment
            .sensorNode(element)
            .filter(node -> !node.enriched() && node.findings().isEmpty())
            .isPresent();
  }

  /**
   * Whether there is an error or a warning about the element itself. For objects and areas without
   * metadata only errors count, as not being enriched yet is no fault.
   */
  boolean faulty(DocumentElement element) {
    return faulty.contains(element);
  }

  /** Returns the problems of a node, with those of its metadata, in document order. */
  List<ElementFinding> about(DocumentElement node) {
    return all.stream()
        .flatMap(
            entry ->
                entry
                    .element()
                    .filter(element -> describes(element, node))
                    .map(
                        element ->
                            new ElementFinding(
                                element, entry.severity(), entry.message(), entry.fix()))
                    .stream())
        .toList();
  }

  /** Whether an element is a node or stands in its metadata. */
  private static boolean describes(DocumentElement element, DocumentElement node) {
    DocumentElement at = element;
    while (at != node && at.name().startsWith("Metadata") && at.parent().isPresent()) {
      at = at.parent().get();
    }
    return at == node;
  }

  List<ProblemEntry> entries() {
    return all;
  }

  /**
   * @param checking whether the checks of the present text have not ended
   */
  ProblemCounts counts(boolean checking) {
    return ProblemCounts.of(checking, all, unenriched, enrichable);
  }
}
