package org.selectiverenderer.enricher.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.authoring.placement.PlacementEdits;
import org.selectiverenderer.authoring.placement.PoseField;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Gives nodes of the session's document other poses, and keeps what is selected selected, also
 * where a node gets a Transform around it.
 */
public final class PlacementEditor {
  private final EnricherSession session;

  /** Creates the editor of a session's document. */
  public PlacementEditor(EnricherSession session) {
    this.session = session;
  }

  /** Returns the placement of a node; empty if it has none that could be changed. */
  public Optional<Placement> placement(DocumentElement node) {
    return Placement.of(session.document(), session.catalogue(), node);
  }

  /**
   * Gives nodes their poses; they stay selected.
   *
   * @param verb key of the undo step's name in the bundle {@code placement}
   * @return whether anything was changed
   */
  public boolean place(List<Placement> placed, String verb) {
    String what =
        placed.size() == 1
            ? name(placed.get(0).node())
            : Texts.of("placement.nodes", String.valueOf(placed.size()));
    return perform(
        () ->
            new PlacementEdits(session.document())
                .place(placed, Texts.of("placement." + verb, what)));
  }

  /**
   * Gives a node a value that the author typed; what is selected stays selected.
   *
   * @param value as {@link PoseField#value} returns it
   * @param verb key of the undo step's name in the bundle {@code placement}
   */
  public void set(Placement placed, PoseField field, String value, String verb) {
    String step = Texts.of("placement." + verb, name(placed.node()));
    perform(() -> new PlacementEdits(session.document()).set(placed, field, value, step));
  }

  private static String name(DocumentElement node) {
    return node.def().or(node::use).orElse(node.name());
  }

  /**
   * Makes an edit after which the selected nodes, perhaps with a Transform around, are selected.
   */
  private boolean perform(Supplier<Edit> making) {
    List<DocumentElement> selected = session.selectedElements();
    boolean[] changed = {false};
    session.attempt(
        () -> {
          Edit edit = making.get();
          if (!edit.isEmpty()) {
            List<List<Integer>> paths = selected.stream().map(each -> path(each, edit)).toList();
            session.document().perform(edit);
            changed[0] = true;
            List<DocumentElement> now = new ArrayList<>();
            paths.forEach(path -> found(path).ifPresent(now::add));
            session.selectAll(now, this);
          }
        });
    return changed[0];
  }

  /** Returns the child indices from the root by which an element is found after an edit. */
  private static List<Integer> path(DocumentElement element, Edit edit) {
    List<Integer> path = new ArrayList<>();
    Optional<DocumentElement> at = Optional.of(element);
    while (at.flatMap(DocumentElement::parent).isPresent()) {
      DocumentElement node = at.get();
      boolean wrapped =
          edit.changes().stream()
              .anyMatch(each -> each.from() == node.start() && each.to() == node.end());
      if (wrapped) {
        path.add(0, 0); // the only child of its new Transform
      }
      at = node.parent();
      path.add(0, at.get().children().indexOf(node));
    }
    return path;
  }

  private Optional<DocumentElement> found(List<Integer> path) {
    Optional<DocumentElement> at = session.document().tree().map(tree -> tree.root());
    for (int index : path) {
      at =
          at.filter(node -> index < node.children().size()).map(node -> node.children().get(index));
    }
    return at;
  }
}
