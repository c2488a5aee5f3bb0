package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates the edits that cut, paste, move and insert elements. Each is for the document's present
 * state and one undo step. All throw {@link EditRejectedException} with a sentence for the author
 * where an edit would break the scene.
 */
public final class StructureEdits {
  private final SceneDocument document;
  private final Containment containment;
  private final NodeCatalogue catalogue;
  private final ChoiceGuard choices;

  public StructureEdits(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
    this.containment = new Containment(catalogue);
    this.choices = new ChoiceGuard(document, catalogue);
  }

  private ElementTree tree() {
    return document
        .tree()
        .orElseThrow(
            () ->
                new EditRejectedException(
                    "The text is not well formed; correct it in the source first"));
  }

  /** Returns the elements that no other one of them contains, in the order of the document. */
  public static List<DocumentElement> outermost(List<DocumentElement> elements) {
    return elements.stream()
        .filter(DocumentElement::attached)
        .filter(each -> elements.stream().noneMatch(other -> other != each && other.contains(each)))
        .distinct()
        .sorted(Comparator.comparingInt(DocumentElement::start))
        .toList();
  }

  /** Returns the X3D source of elements for the clipboard, without their common indentation. */
  public String text(List<DocumentElement> elements) {
    List<DocumentElement> all = outermost(elements);
    return all.isEmpty() ? "" : String.join("\n", new Pieces(document, all).lines()) + "\n";
  }

  /**
   * Removes elements with the ROUTEs, IMPORTs and EXPORTs of their nodes.
   *
   * @param verb begins the name of the undo step: {@code Cut} or {@code Delete}
   */
  public Edit remove(List<DocumentElement> elements, String verb) {
    tree();
    List<DocumentElement> all = outermost(elements);
    all.forEach(choices::taken);
    return new Edit(verb + " " + called(all), new NodeEdits(document).removal(all));
  }

  /**
   * Pastes text: into the selected element where its fields take the nodes, else behind it.
   *
   * @param selected the selected element; empty for the end of the scene
   * @param text X3D or VRML source of one or several nodes
   */
  public StructureChange paste(Optional<DocumentElement> selected, String text) {
    SceneFragment fragment = SceneFragment.parse(text, catalogue);
    DocumentElement target = selected.map(this::sceneOf).orElseGet(this::scene);
    return insert(fragment, targets().positionFor(target, fragment), "Paste ");
  }

  private PasteTargets targets() {
    return new PasteTargets(document, containment, catalogue);
  }

  /** Inserts nodes at a position. */
  StructureChange insert(SceneFragment fragment, ChildPosition position, String verb) {
    Pieces pieces = new Pieces(fragment.document(), fragment.elements());
    place(pieces, fragment.elements(), position.parent(), Set.of());
    TextEdit where = insertion(position, Set.of(), List.of("<N/>"));
    defined(pieces.open(), position.parent(), where.from(), Set.of());
    pieces.rename(new UniqueNameGenerator(tree(), position.parent()), Map.of());
    TextEdit change = insertion(position, Set.of(), pieces.lines());
    int count = fragment.elements().size();
    List<TextEdit> changes = new ArrayList<>();
    changes.addAll(new NeededComponents(document, catalogue).of(fragment.elements()));
    changes.add(change);
    return new StructureChange(
        new Edit(verb + called(fragment.elements()), changes),
        List.of(new StructureChange.Added(change, count)));
  }

  private DocumentElement scene() {
    return tree()
        .scene()
        .orElseThrow(() -> new EditRejectedException("The file has no Scene to paste into"));
  }

  private DocumentElement sceneOf(DocumentElement selected) {
    return selected.name().equals("X3D") || selected.name().equals("head") ? scene() : selected;
  }

  /**
   * Moves elements to a position.
   *
   * @param position a position in the document before the move
   */
  public StructureChange move(List<DocumentElement> elements, ChildPosition position) {
    List<DocumentElement> all = outermost(elements);
    Set<DocumentElement> leaving = Set.copyOf(all);
    DocumentElement parent = position.parent();
    for (DocumentElement each : all) {
      if (!NodeEdits.removable(each)) {
        throw new EditRejectedException("Every scene needs its element " + each + "; it stays");
      }
      choices.taken(each);
      if (each.contains(parent)) {
        throw new EditRejectedException(each + " cannot be moved into itself");
      }
      if (!ElementScope.shared(each, parent)) {
        throw new EditRejectedException(
            "The body of a prototype has names of its own: copy " + each + " and paste it instead");
      }
    }
    if (all.isEmpty() || stays(all, position)) {
      return new StructureChange(new Edit("", List.of()), List.of());
    }
    Pieces pieces = new Pieces(document, all);
    pieces.written();
    place(pieces, all, parent, leaving);
    int at = insertion(position, leaving, List.of("<N/>")).from();
    defined(pieces.open(), parent, at, leaving);
    usedAfter(pieces.defined(), parent, at, leaving);
    declared(at, leaving);
    SourceFormatter layout = document.layout();
    List<TextEdit> changes = new ArrayList<>();
    all.forEach(each -> changes.add(layout.remove(each)));
    TextEdit change = insertion(position, leaving, pieces.lines());
    changes.add(change);
    return new StructureChange(
        new Edit("Move " + called(all), changes),
        List.of(new StructureChange.Added(change, all.size())));
  }

  /** Copies elements to a position, with new names for the named ones. */
  public StructureChange copy(List<DocumentElement> elements, ChildPosition position) {
    List<DocumentElement> all = outermost(elements);
    Pieces pieces = new Pieces(document, all);
    place(pieces, all, position.parent(), Set.of());
    int at = insertion(position, Set.of(), List.of("<N/>")).from();
    defined(pieces.open(), position.parent(), at, Set.of());
    pieces.rename(new UniqueNameGenerator(tree(), position.parent()), Map.of());
    TextEdit change = insertion(position, Set.of(), pieces.lines());
    return new StructureChange(
        new Edit("Copy " + called(all), List.of(change)),
        List.of(new StructureChange.Added(change, all.size())));
  }

  /**
   * Moves siblings one place up or down among their siblings.
   *
   * @param down whether towards the end
   */
  public StructureChange step(List<DocumentElement> elements, boolean down) {
    List<DocumentElement> all = outermost(elements);
    Optional<DocumentElement> parent = all.stream().findFirst().flatMap(DocumentElement::parent);
    if (parent.isEmpty() || all.stream().anyMatch(each -> !each.parent().equals(parent))) {
      throw new EditRejectedException("Select nodes of one parent to move them up or down");
    }
    List<DocumentElement> siblings = parent.get().children();
    int from = siblings.indexOf(all.get(down ? all.size() - 1 : 0));
    int to = down ? from + 2 : from - 1;
    if (to < 0 || to > siblings.size()) {
      throw new EditRejectedException(
          down ? "It is the last one already" : "It is the first one already");
    }
    return move(all, new ChildPosition(parent.get(), to));
  }

  private static boolean stays(List<DocumentElement> all, ChildPosition position) {
    List<DocumentElement> siblings = position.parent().children();
    int first = siblings.indexOf(all.get(0));
    return first >= 0
        && first + all.size() <= siblings.size()
        && siblings.subList(first, first + all.size()).equals(all)
        && position.index() >= first
        && position.index() <= first + all.size();
  }

  /** Writes the container fields that elements need in a parent. */
  private void place(
      Pieces pieces,
      List<DocumentElement> elements,
      DocumentElement parent,
      Set<DocumentElement> leaving) {
    if (parent.isReference()) {
      throw new EditRejectedException(
          parent + " comes from an entity of the DOCTYPE; change it in the source");
    }
    FieldOccupancy fields = new FieldOccupancy(containment, parent, leaving);
    for (DocumentElement each : elements) {
      Containment.Place place =
          fields
              .give(each)
              .orElseThrow(
                  () ->
                      new EditRejectedException(
                          containment.accepts(parent, each)
                              ? targets().taken(each, parent)
                              : "%s cannot go into %s; %s"
                                  .formatted(each, parent, targets().homes(each))));
      pieces.place(each, place, containment);
    }
  }

  /** Refuses a place before the nodes that are referred to there. */
  private void defined(
      Set<String> names, DocumentElement parent, int at, Set<DocumentElement> leaving) {
    for (String name : names) {
      Optional<DocumentElement> node = tree().named(name, parent);
      if (node.isEmpty()) {
        throw new EditRejectedException(
            "It uses the node %s (USE), which this scene does not have; copy that one along"
                .formatted(name));
      }
      boolean along = leaving.stream().anyMatch(each -> each.contains(node.get()));
      if (!along && node.get().start() >= at) {
        throw new EditRejectedException(
            "It uses %s (USE), which must be before it: choose a place after line %d"
                .formatted(name, document.location(node.get().start()).line()));
      }
    }
  }

  /** Refuses a place after nodes that refer to what is moved there. */
  private void usedAfter(
      Set<String> names, DocumentElement parent, int at, Set<DocumentElement> leaving) {
    ElementScope.visit(
        parent,
        each -> {
          boolean before =
              each.use().filter(names::contains).isPresent()
                  && each.start() < at
                  && leaving.stream().noneMatch(moved -> moved.contains(each));
          if (before) {
            throw new EditRejectedException(
                "%s is used in line %d (USE) and must stay before that"
                    .formatted(each.use().orElse(""), document.location(each.start()).line()));
          }
        });
  }

  /** Refuses a move after which an instance would come before the declaration of its prototype. */
  private void declared(int at, Set<DocumentElement> leaving) {
    for (DocumentElement instance : tree().instances()) {
      Optional<DocumentElement> declaration =
          instance.text("name").flatMap(name -> tree().prototype(name.strip(), instance));
      if (declaration.isEmpty()) {
        continue;
      }
      String name = instance.text("name").orElse("").strip();
      boolean moves = leaving.stream().anyMatch(each -> each.contains(instance));
      boolean along = leaving.stream().anyMatch(each -> each.contains(declaration.get()));
      if (moves && !along && declaration.get().start() >= at) {
        throw new EditRejectedException(
            "It has an instance of the prototype %s, which must be before it: choose a place after line %d"
                .formatted(name, document.location(declaration.get().start()).line()));
      }
      if (along && !moves && instance.start() < at) {
        throw new EditRejectedException(
            "The prototype %s must stay before its instance in line %d"
                .formatted(name, document.location(instance.start()).line()));
      }
    }
  }

  private TextEdit insertion(
      ChildPosition position, Set<DocumentElement> leaving, List<String> lines) {
    choices.given(position);
    SourceFormatter layout = document.layout();
    List<DocumentElement> children = position.parent().children();
    for (int i = position.index() - 1; i >= 0; i--) {
      if (!leaving.contains(children.get(i))) {
        return layout.insertAfter(children.get(i), lines);
      }
    }
    for (int i = position.index(); i < children.size(); i++) {
      if (!leaving.contains(children.get(i))) {
        return layout.insertBefore(children.get(i), lines);
      }
    }
    TextEdit last = layout.insertLast(position.parent(), lines);
    return children.isEmpty()
        ? last
        : TextEdit.insert(
            layout.remove(children.get(children.size() - 1)).to(), last.text()); // all leave
  }

  static String called(List<DocumentElement> elements) {
    if (elements.size() != 1) {
      return elements.size() + " nodes";
    }
    DocumentElement only = elements.get(0);
    return only.def().or(only::use).orElse(only.name());
  }

  /**
   * Copies each element behind itself under the next free name.
   *
   * @param shift the way from a node to its copy in the coordinates of its parent, for nodes that
   *     are somewhere
   */
  public StructureChange duplicate(
      List<DocumentElement> elements, Function<DocumentElement, Vector3d> shift) {
    List<DocumentElement> all = outermost(elements);
    ElementTree tree = tree();
    Map<DocumentElement, UniqueNameGenerator> scopes = new HashMap<>();
    List<StructureChange.Added> added = new ArrayList<>();
    for (DocumentElement each : all) {
      if (!NodeEdits.removable(each)) {
        throw new EditRejectedException("A file has only one " + each.name());
      }
      DocumentElement parent = each.parent().orElseThrow();
      choices.given(ChildPosition.after(each));
      Pieces pieces = new Pieces(document, List.of(each));
      place(pieces, List.of(each), parent, Set.of());
      UniqueNameGenerator names =
          scopes.computeIfAbsent(
              ElementScope.of(each), scope -> new UniqueNameGenerator(tree, each));
      Map<DocumentElement, String> wanted = new HashMap<>();
      each.def().ifPresent(def -> wanted.put(each, names.unused(def)));
      pieces.rename(names, wanted);
      List<String> lines =
          new ShiftedCopy(document, containment, catalogue).lines(pieces, each, shift.apply(each));
      added.add(new StructureChange.Added(document.layout().insertAfter(each, lines), 1));
    }
    return new StructureChange(
        new Edit(
            "Duplicate " + called(all),
            new ArrayList<>(
                new LinkedHashSet<>(added.stream().map(StructureChange.Added::change).toList()))),
        added);
  }
}
