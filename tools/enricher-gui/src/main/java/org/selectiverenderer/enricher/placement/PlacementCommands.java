package org.selectiverenderer.enricher.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.placement.Arrangement;
import org.selectiverenderer.authoring.placement.GroupEdits;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.menu.NodeCommand;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The commands that place the selected nodes: move, turn, scale, align, distribute, group, ungroup.
 * Each is one undo step; what is refused is told in the status bar.
 */
public final class PlacementCommands {
  private final EnricherSession session;
  private final AsyncSceneQueries probe;
  private final PlacementEditor editor;

  /**
   * @param probe measures nodes in the running scene
   */
  public PlacementCommands(EnricherSession session, AsyncSceneQueries probe) {
    this.session = session;
    this.probe = probe;
    editor = new PlacementEditor(session);
  }

  /** The selected nodes that are in no other selected one. */
  private List<DocumentElement> outermost() {
    List<DocumentElement> all =
        session.selectedElements().stream().filter(DocumentElement::attached).toList();
    return all.stream()
        .filter(node -> all.stream().noneMatch(other -> other != node && other.contains(node)))
        .toList();
  }

  private Optional<Placement> placement(DocumentElement node) {
    return editor.placement(node);
  }

  /**
   * Begins a drag of the selected nodes.
   *
   * @param boxes of the selected nodes
   * @return empty if none of them can be placed, or the document is read-only
   */
  public Optional<PlacementDrag> drag(List<ObjectBox> boxes) {
    if (session.document().locked().isPresent() || session.document().fault().isPresent()) {
      return Optional.empty();
    }
    List<DocumentElement> nodes = outermost();
    List<PlacementDrag.Item> items = new ArrayList<>();
    for (ObjectBox box : boxes) {
      if (nodes.contains(box.element())) {
        placement(box.element())
            .ifPresent(placed -> items.add(new PlacementDrag.Item(placed, box)));
      }
    }
    return items.isEmpty() ? Optional.empty() : Optional.of(new PlacementDrag(items));
  }

  /**
   * Gives nodes their poses; they stay selected.
   *
   * @param verb key of the undo step's name in the bundle {@code placement}
   * @return whether anything was changed
   */
  public boolean place(List<Placement> placed, String verb) {
    return editor.place(placed, verb);
  }

  private interface Shifting {
    List<Vector3d> of(List<BoundingBox> boxes);
  }

  private void arrange(String verb, int least, Shifting shifting) {
    List<DocumentElement> nodes = outermost();
    if (nodes.size() < least) {
      session.message(Texts.of("placement.select", String.valueOf(least)));
      return;
    }
    long revision = session.document().revision();
    probe.boxes(
        nodes,
        boxes -> {
          if (revision == session.document().revision()) {
            arrange(verb, least, shifting, boxes);
          } else {
            session.message(Texts.of("node.changedMeanwhile"));
          }
        });
  }

  private void arrange(String verb, int least, Shifting shifting, List<ObjectBox> boxes) {
    Optional<PlacementDrag> drag = drag(boxes);
    List<PlacementDrag.Item> items = drag.map(PlacementDrag::items).orElse(List.of());
    if (items.size() < least) {
      session.message(Texts.of("placement.seen", String.valueOf(least)));
      return;
    }
    List<Vector3d> shifts = shifting.of(items.stream().map(item -> item.box().bounds()).toList());
    List<Placement> placed = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      if (shifts.get(i).length() > 1e-6) {
        placed.addAll(new PlacementDrag(List.of(items.get(i))).moved(shifts.get(i)));
      }
    }
    if (placed.isEmpty() || !place(placed, verb)) {
      session.message(Texts.of("placement.already"));
    }
  }

  /** Aligns the selected nodes. */
  public void align(int axis, Arrangement.Side side) {
    arrange("align", 2, boxes -> Arrangement.align(boxes, axis, side));
  }

  /** Makes the gaps between the selected nodes equal. */
  public void distribute(int axis) {
    arrange("distribute", 3, boxes -> Arrangement.distribute(boxes, axis));
  }

  /** Puts each selected node on what is below it. */
  public void putOnFloor() {
    long revision = session.document().revision();
    List<DocumentElement> nodes = outermost();
    probe.boxes(
        nodes,
        boxes ->
            probe.support(
                boxes,
                heights -> {
                  // Heights of nodes that are no longer those selected would move others.
                  if (revision == session.document().revision() && nodes.equals(outermost())) {
                    putOnFloor(boxes, heights);
                  } else {
                    session.message(Texts.of("node.changedMeanwhile"));
                  }
                }));
  }

  private void putOnFloor(List<ObjectBox> boxes, List<OptionalDouble> heights) {
    List<ObjectBox> above = new ArrayList<>();
    List<Vector3d> shifts = new ArrayList<>();
    for (int i = 0; i < Math.min(boxes.size(), heights.size()); i++) {
      if (heights.get(i).isPresent() && placement(boxes.get(i).element()).isPresent()) {
        above.add(boxes.get(i));
        double down = heights.get(i).getAsDouble() - boxes.get(i).bounds().minY();
        shifts.add(new Vector3d(0, down, 0));
      }
    }
    if (above.isEmpty()) {
      session.message(Texts.of("placement.nofloor"));
    } else {
      arrange("floor", 1, all -> shifts, above);
    }
  }

  /** Moves the selected nodes by a vector of the scene. */
  public void nudge(Vector3d shift) {
    List<Placement> placed = new ArrayList<>();
    for (DocumentElement node : outermost()) {
      placement(node)
          .ifPresent(
              of ->
                  placed.addAll(
                      new PlacementDrag(
                              List.of(
                                  new PlacementDrag.Item(
                                      of,
                                      new ObjectBox(
                                          node, BoundingBox.EMPTY, of.own(), BoundingBox.EMPTY))))
                          .moved(shift)));
    }
    if (!placed.isEmpty()) {
      place(placed, "move");
    }
  }

  private GroupEdits groups() {
    return new GroupEdits(session.document(), session.catalogue());
  }

  /** Puts the selected nodes into a new Transform and selects that. */
  public void group() {
    List<DocumentElement> nodes = outermost();
    if (nodes.isEmpty()) {
      session.message(Texts.of("placement.select", "1"));
      return;
    }
    session.attempt(
        () -> {
          String name = new NodeEdits(session.document()).free("Group", nodes.get(0));
          DocumentElement parent = nodes.get(0).parent().orElseThrow();
          session.document().perform(groups().group(nodes, name));
          session
              .document()
              .tree()
              .flatMap(tree -> tree.named(name, parent.attached() ? parent : tree.root()))
              .ifPresent(group -> session.select(group, this));
        });
  }

  /** Replaces the selected group by what is in it, and selects that. */
  public void ungroup() {
    Optional<DocumentElement> group = session.selection().filter(DocumentElement::attached);
    if (group.isEmpty()) {
      session.message(Texts.of("placement.select", "1"));
      return;
    }
    session.attempt(
        () -> {
          DocumentElement parent = group.get().parent().orElse(group.get());
          int from = parent.children().indexOf(group.get());
          int count = group.get().children().size();
          session.document().perform(groups().ungroup(group.get()));
          List<DocumentElement> now =
              parent.attached() && from >= 0
                  ? parent
                      .children()
                      .subList(from, Math.min(from + count, parent.children().size()))
                  : List.of();
          session.selectAll(List.copyOf(now), this);
        });
  }

  /** Selects the node around the one selected last. */
  public void selectParent() {
    session
        .selection()
        .flatMap(DocumentElement::parent)
        .filter(parent -> !parent.name().equals("X3D"))
        .ifPresent(parent -> session.select(parent, this));
  }

  /** Returns the commands for the context menu of the selected nodes. */
  public List<NodeCommand> commands() {
    Function<DocumentElement, Boolean> placed =
        node -> session.document().locked().isEmpty() && placement(node).isPresent();
    return List.of(
        new NodeCommand("groupNodes", Texts.of("placement.group"), placed::apply, node -> group()),
        new NodeCommand(
            "ungroupNode",
            Texts.of("placement.ungroup"),
            node -> session.document().locked().isEmpty() && GroupEdits.isGroup(node),
            node -> ungroup()),
        new NodeCommand(
            "putOnFloor", Texts.of("placement.onfloor"), placed::apply, node -> putOnFloor()),
        new NodeCommand(
            "selectParent",
            Texts.of("placement.parent"),
            node -> node.parent().isPresent(),
            node -> selectParent()));
  }

  /** The elements around one and itself, the outermost first; from the scene on. */
  public static List<DocumentElement> path(DocumentElement of) {
    List<DocumentElement> path = new ArrayList<>();
    for (Optional<DocumentElement> at = Optional.of(of); at.isPresent(); at = at.get().parent()) {
      if (!at.get().name().equals("X3D")) {
        path.add(at.get());
      }
    }
    path.sort(Comparator.comparingInt(DocumentElement::start));
    return path;
  }
}
