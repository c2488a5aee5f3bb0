package org.selectiverenderer.enricher.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The versions that an author asks for, and what they come to. A result is of the goals that it was
 * worked out for; while there are newer ones it is shown, but not applied. For one thread.
 */
final class VersionsModel {
  private static final Set<String> OBJECTS =
      Set.of("Transform", "Group", "Shape", "Switch", "Inline", "StaticGroup", "Anchor");

  /** Most versions besides the original. */
  static final int MOST = 8;

  private final List<Runnable> listeners = new ArrayList<>();
  private final List<VersionGoal> goals = new ArrayList<>(List.of(VersionGoal.percent(50)));
  private Optional<ComputedVersions> result = Optional.empty();
  private String object;
  private String name = "";
  private int maxVertex;
  private int existing;

  /** Whether it is not known yet which versions the object has. */
  private boolean beginning = true;

  private long wanted = 1;
  private long worked;

  VersionsModel(String object) {
    this.object = object;
  }

  /** The DEF names that can be made versions of, in document order. */
  static List<String> objects(SceneDocument document) {
    List<String> names = new ArrayList<>();
    document
        .tree()
        .ifPresent(
            tree ->
                tree.root()
                    .visit(
                        element -> {
                          if (OBJECTS.contains(element.name())) {
                            element.def().ifPresent(names::add);
                          }
                        }));
    return names;
  }

  /** The DEF of an element or of what it stands in that is an object; empty for none. */
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

  /** Another object; its versions begin as percents, as its vertices are not known yet. */
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

  /** What the files that are made are named after; empty for the name that they have anyway. */
  String name() {
    return name;
  }

  void name(String other) {
    if (!other.strip().equals(name)) {
      name = other.strip();
      changed();
    }
  }

  /** How many versions the object has in the scene; 0 for none. */
  int existing() {
    return existing;
  }

  /** Whether it is to be found out first which versions there are. */
  boolean beginning() {
    return beginning;
  }

  /** The numbers of versions that stay as they are. */
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

  /** One version more, with half the vertices of the last one. */
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

  /** One version less; one stays. */
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

  /** The document has changed, so that all has to be worked out again. */
  void outdate() {
    changed();
  }

  /** What is asked for now; a result carries the number that it was worked out for. */
  long wanted() {
    return wanted;
  }

  /** Takes a result; one of older goals only if nothing newer is there. */
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

  /** Versions that are there are kept, until the author wants others. */
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
    worked = wanted; // what is shown is what these goals come to
  }

  Optional<ComputedVersions> result() {
    return result;
  }

  /** The vertices of the original; 0 while not known. */
  int maxVertex() {
    return maxVertex;
  }

  /** Whether the result is that of the goals as they are. */
  boolean current() {
    return worked == wanted;
  }

  boolean applicable() {
    return current()
        && result.flatMap(ComputedVersions::edit).filter(edit -> !edit.isEmpty()).isPresent();
  }
}
