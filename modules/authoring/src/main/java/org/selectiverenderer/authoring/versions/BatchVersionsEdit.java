package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * An edit that makes versions of many objects of a scene as one undo step, their files included. An
 * object without a DEF name gets one. Each object is planned on the text that the one before has
 * left, so that what one moves to its file the next does not look for in the scene.
 *
 * @param objects the objects that get versions, in the order of the scene
 * @param files the files of all versions
 * @param scene the changed scene
 * @param edit the change of the scene's text
 * @param revision the revision of the document that was planned on
 */
public record BatchVersionsEdit(
    List<VersionedObject> objects,
    List<PlannedFile> files,
    PlannedFile scene,
    Edit edit,
    long revision) {
  /** Copies the lists. */
  public BatchVersionsEdit {
    objects = List.copyOf(objects);
    files = List.copyOf(files);
  }

  /**
   * An object to make versions of.
   *
   * @param goals the goals of versions 2, 3 and so on
   */
  public record Item(VersionCandidate object, List<SimplificationTarget> goals) {
    /** Copies the list. */
    public Item {
      goals = List.copyOf(goals);
    }
  }

  /**
   * An object that gets versions.
   *
   * @param name its DEF name, which may be new
   * @param versions its versions, the original first
   */
  public record VersionedObject(String name, List<ObjectVersion> versions) {
    /** Copies the list. */
    public VersionedObject {
      versions = List.copyOf(versions);
    }
  }

  /**
   * Plans the versions. This takes a while, so it must not run on the event dispatch thread. It
   * writes nothing. An object without versions to make is left as it is, which is reported.
   *
   * @param request the scene and the output; its object, goals, kept versions and name are not used
   * @param items the objects, found in the same snapshot
   * @throws SceneNotEditableException if the scene's text cannot be changed
   * @throws IOException if a file cannot be read, with a one-line message that names it
   * @throws CancellationException if the progress throws it
   */
  public static BatchVersionsEdit plan(
      DocumentSnapshot snapshot,
      VersionsEdit.Request request,
      List<Item> items,
      NodeCatalogue catalogue,
      BatchProgress progress,
      ProblemCollector problems)
      throws IOException {
    Planning planning = new Planning(snapshot, request, catalogue, problems);
    List<Item> order = new ArrayList<>(items);
    // The largest first, since each leaves a smaller text for the others.
    order.sort(Comparator.comparingInt((Item item) -> item.object().polygons()).reversed());
    for (int i = 0; i < order.size(); i++) {
      progress.done((double) i / order.size(), order.get(i).object().name());
      planning.add(order.get(i));
    }
    progress.done(1, "");
    return planning.result();
  }

  /** Returns whether nothing would change. */
  public boolean isEmpty() {
    return objects.isEmpty();
  }

  /**
   * Writes the versions' files, all or none, and edits the document, as one undo step.
   *
   * @throws org.selectiverenderer.authoring.EditRejectedException if the document has changed since
   *     it was planned
   * @throws IOException if a file cannot be written; nothing has changed then
   */
  public void apply(SceneDocument document) throws IOException {
    VersionsEdit.apply(document, revision, edit, files, objects.get(0).name());
  }

  /**
   * Writes the changed ones of the scene and the versions' files, all or none.
   *
   * @return see {@link org.selectiverenderer.base.files.FileTransaction#commit}
   * @throws IOException if one cannot be written, with a one-line message that names it
   */
  public List<Path> write() throws IOException {
    List<PlannedFile> all = new ArrayList<>(files);
    all.add(scene);
    return VersionsEdit.write(all);
  }

  /** The state of planning: what is made so far. */
  private static final class Planning {
    private final DocumentSnapshot snapshot;
    private final VersionsEdit.Request request;
    private final NodeCatalogue catalogue;
    private final ProblemCollector problems;
    private final ComposedEdit text;
    private final SortedMap<Integer, VersionedObject> objects = new TreeMap<>();
    private final List<PlannedFile> files = new ArrayList<>();
    private final Set<String> taken = new HashSet<>();
    private final List<Shift> shifts = new ArrayList<>();
    private DocumentSnapshot present;

    /** A change of the text before which offsets stay and behind which they shift. */
    private record Shift(int from, int to, int growth) {}

    Planning(
        DocumentSnapshot snapshot,
        VersionsEdit.Request request,
        NodeCatalogue catalogue,
        ProblemCollector problems) {
      this.snapshot = snapshot;
      this.present = snapshot;
      this.request = request;
      this.catalogue = catalogue;
      this.problems = problems;
      this.text = new ComposedEdit(snapshot.text());
    }

    void add(Item item) throws IOException {
      ElementTree tree = elements();
      Optional<DocumentElement> element = tree.at(now(item.object().start()));
      if (element.isEmpty()) {
        return;
      }
      List<TextEdit> naming = List.of();
      DocumentSnapshot named = present;
      String name = element.get().def().orElse("");
      if (name.isEmpty()) {
        name = new UniqueNameGenerator(tree).free(item.object().name());
        naming = List.of(naming(element.get(), name));
        named = changed(naming);
      }
      VersionsEdit.Request own = request.of(name, item.goals());
      Optional<VersionsEdit> plan = VersionsEdit.plan(named, own, catalogue, problems);
      for (int i = 2; plan.isPresent() && clashes(plan.get()); i++) {
        plan =
            VersionsEdit.plan(
                named, own.named(ObjectFinder.name(name) + "_" + i), catalogue, problems);
      }
      if (plan.isEmpty()) {
        return;
      }
      List<ObjectVersion> versions = plan.get().versions();
      int polygons = versions.get(0).polygons();
      if (versions.stream().skip(1).noneMatch(version -> version.polygons() < polygons)) {
        problems.info(
            SourceLocation.of(snapshot.name()),
            "'%s' cannot have fewer polygons for its goal; it is left as it is".formatted(name));
        return;
      }
      adopt(naming);
      adopt(plan.get().edit().changes());
      plan.get().files().forEach(file -> taken.add(key(file.file())));
      files.addAll(plan.get().files());
      objects.put(item.object().start(), new VersionedObject(name, versions));
    }

    /** Returns the change that gives a name, before the other attributes as authors write it. */
    private TextEdit naming(DocumentElement element, String name) {
      char quote = present.layout().quote(element);
      return TextEdit.insert(
          element.start() + 1 + element.name().length(),
          SourceFormatter.written("DEF", name, quote));
    }

    private ElementTree elements() throws SceneNotEditableException {
      try {
        return present.elements();
      } catch (XmlParseException e) {
        throw new SceneNotEditableException(e.fault().location() + ": " + e.getMessage());
      }
    }

    /** Returns where a character of the first text is now. */
    private int now(int start) {
      int at = start;
      for (Shift shift : shifts) {
        at += at >= shift.to() && at > shift.from() ? shift.growth() : 0;
      }
      return at;
    }

    private boolean clashes(VersionsEdit plan) {
      return plan.files().stream().anyMatch(file -> taken.contains(key(file.file())));
    }

    /** Returns the same for files that some file systems take for one. */
    private static String key(Path file) {
      return file.toString().toLowerCase(Locale.ROOT);
    }

    private DocumentSnapshot changed(List<TextEdit> changes) {
      String result = TextEdit.applied(changes, present.text()).toString();
      return new DocumentSnapshot(
          present.name(), present.revision(), result, present.locked(), present.encoder());
    }

    private void adopt(List<TextEdit> changes) {
      if (!changes.isEmpty()) {
        present = changed(changes);
        text.add(changes);
        // From the last to the first, so that each is told in offsets that the others leave alone.
        for (int i = changes.size() - 1; i >= 0; i--) {
          TextEdit change = changes.get(i);
          shifts.add(
              new Shift(
                  change.from(),
                  change.to(),
                  change.text().length() - (change.to() - change.from())));
        }
      }
    }

    BatchVersionsEdit result() throws IOException {
      Edit edit = new Edit("Make versions of " + objects.size() + " objects", text.changes());
      PlannedFile scene = VersionsPlanner.planned(request.output(), snapshot.bytes(edit), false);
      return new BatchVersionsEdit(
          List.copyOf(objects.values()), files, scene, edit, snapshot.revision());
    }
  }
}
