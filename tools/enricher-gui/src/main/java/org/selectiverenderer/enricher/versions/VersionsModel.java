package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/**
 * The model of the versions dialog: the goals of the versions and the last computed result. A
 * result for older goals is shown, but cannot be applied. Not thread-safe.
 */
final class VersionsModel {
  private static final Set<String> OBJECTS =
      Set.of(
          "Transform",
          "Group",
          "Shape",
          "Switch",
          "Inline",
          "StaticGroup",
          "Anchor",
          "ProtoInstance");

  /** Most versions besides the original. */
  static final int MOST = 8;

  private final List<Runnable> listeners = new ArrayList<>();
  private final List<VersionGoal> goals = new ArrayList<>(List.of(VersionGoal.percent(50)));
  private Optional<ComputedVersions> result = Optional.empty();
  private final Optional<DocumentElement> unnamed;
  private final String proposed;
  private String object;
  private String name = "";
  private int maxVertex;
  private int existing;

  /** Whether the object's existing versions are still unknown. */
  private boolean beginning = true;

  private long wanted = 1;
  private long worked;

  VersionsModel(String object) {
    this.object = object;
    this.unnamed = Optional.empty();
    this.proposed = "";
  }

  /** Creates a model for an element without a DEF, which is given a name in its files only. */
  VersionsModel(DocumentElement unnamed, String proposed) {
    this.object = proposed;
    this.unnamed = Optional.of(unnamed);
    this.proposed = proposed;
  }

  /**
   * Creates a model for the object that an element is or is part of: the nearest with a DEF name,
   * but a Switch or an instance of a prototype also without one.
   */
  static VersionsModel of(SceneDocument document, DocumentElement element) {
    String named = nameOf(element);
    boolean own = element.name().equals("Switch") || element.name().equals("ProtoInstance");
    boolean itself = element.def().isEmpty() && element.use().isEmpty() && isObject(element);
    return itself && (own || named.isEmpty()) && document.tree().isPresent()
        ? new VersionsModel(element, VersionsEdit.proposedName(document, element))
        : new VersionsModel(named);
  }

  /** Whether versions may be made of elements of that type. */
  static boolean isObject(DocumentElement element) {
    return OBJECTS.contains(element.name());
  }

  /** Returns the request for the chosen object. */
  VersionsEdit.Request aimed(VersionsEdit.Request request) {
    return unnamed
        .filter(element -> element.attached() && object.equals(proposed))
        .map(element -> request.at(element.start()))
        .orElse(request);
  }

  /** The DEF names of nodes that versions can be made of, in document order. */
  static List<String> objects(SceneDocument document) {
    List<String> names = new ArrayList<>();
    document
        .tree()
        .ifPresent(
            tree ->
                ElementScope.visit(
                    tree.root(),
                    element -> {
                      if (isObject(element)) {
                        element.def().ifPresent(names::add);
                      }
                    }));
    return names;
  }

  /** The DEF name of an element or of the nearest object around it; empty for none. */
  static String nameOf(DocumentElement element) {
    for (Optional<DocumentElement> at = Optional.of(element);
        at.isPresent();
        at = at.get().parent()) {
      if (OBJECTS.contains(at.get().name()) && at.get().def().isPresent()) {
        return at.get().def().orElseThrow();
      }
    }
    return "";
  }

  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  String object() {
    return object;
  }

  /** The objects to choose from: those with DEF names, and the one that is given a name. */
  List<String> choices(SceneDocument document) {
    List<String> names = new ArrayList<>(objects(document));
    if (!proposed.isEmpty()) {
      names.add(0, proposed);
    }
    return names;
  }

  /** Chooses another object; its goals begin as percentages, as its vertices are not known yet. */
  void object(String other) {
    if (!other.equals(object)) {
      object = other;
      goals.replaceAll(goal -> goal.as(VersionGoal.Kind.PERCENT, maxVertex));
      maxVertex = 0;
      existing = 0;
      beginning = true;
      name = "";
      result = Optional.empty();
      changed();
    }
  }

  /** The base name of the new files; empty for the default. */
  String name() {
    return name;
  }

  void name(String other) {
    if (!other.strip().equals(name)) {
      name = other.strip();
      changed();
    }
  }

  /** The number of versions that the object has in the scene; 0 for none. */
  int existing() {
    return existing;
  }

  /** Whether the first computation must find the existing versions. */
  boolean beginning() {
    return beginning;
  }

  /** The numbers of the versions that are kept as they are. */
  Set<Integer> kept() {
    return IntStream.range(0, goals.size())
        .filter(i -> goals.get(i).keeps())
        .mapToObj(i -> i + 2)
        .collect(Collectors.toSet());
  }

  /** The goals of versions 2, 3 and so on. */
  List<VersionGoal> goals() {
    return List.copyOf(goals);
  }

  void goal(int index, VersionGoal goal) {
    VersionGoal possible = maxVertex == 0 ? goal : goal.within(maxVertex);
    if (!goals.get(index).equals(possible)) {
      goals.set(index, possible);
      changed();
    }
  }

  /** Adds a version with half the vertices of the last one. */
  void add() {
    if (goals.size() < MOST) {
      VersionGoal last = goals.get(goals.size() - 1);
      if (last.keeps()) {
        last = last.as(VersionGoal.Kind.PERCENT, maxVertex);
      }
      goals.add(
          new VersionGoal(last.kind(), Math.max(1, Math.floor(last.value() / 2)))
              .within(Math.max(maxVertex, VersionGoal.FEWEST)));
      changed();
    }
  }

  /** Removes the last version, unless it is the only one. */
  void removeLast() {
    if (goals.size() > 1) {
      goals.remove(goals.size() - 1);
      changed();
    }
  }

  private void changed() {
    wanted++;
    listeners.forEach(Runnable::run);
  }

  /** Marks the result as outdated, as the document has changed. */
  void outdate() {
    changed();
  }

  /** The number of the present request; a result carries the number that it was computed for. */
  long wanted() {
    return wanted;
  }

  /** Takes a result, unless a newer one is there. */
  void take(long number, ComputedVersions computed) {
    if (number > worked) {
      worked = number;
      result = Optional.of(computed);
      maxVertex = computed.maxVertex() > 0 ? computed.maxVertex() : maxVertex;
      existing = computed.existing();
      if (beginning) {
        begin(computed);
      }
      listeners.forEach(Runnable::run);
    }
  }

  /** Sets the goals to keep the existing versions, until the author changes them. */
  private void begin(ComputedVersions computed) {
    beginning = false;
    if (existing < 2) {
      return;
    }
    goals.clear();
    for (int i = 1; i < existing; i++) {
      double vertices =
          i < computed.versions().size() ? computed.versions().get(i).vertices() : maxVertex;
      double percent = Math.round(1000 * vertices / Math.max(1, maxVertex)) / 10.0;
      goals.add(new VersionGoal(VersionGoal.Kind.KEEP, percent).within(maxVertex));
    }
    worked = wanted; // the result is the one for these goals
  }

  Optional<ComputedVersions> result() {
    return result;
  }

  /** The number of vertices of the original; 0 while unknown. */
  int maxVertex() {
    return maxVertex;
  }

  /** Whether the result is for the present goals. */
  boolean current() {
    return worked == wanted;
  }

  boolean applicable() {
    return current()
        && result.flatMap(ComputedVersions::edit).filter(edit -> !edit.isEmpty()).isPresent();
  }
}
