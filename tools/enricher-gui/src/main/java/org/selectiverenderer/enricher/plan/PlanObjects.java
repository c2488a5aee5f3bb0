package org.selectiverenderer.enricher.plan;

import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.placement.ClickSelection;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.PlacementCommands;
import org.selectiverenderer.enricher.placement.PlacementDrag;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The objects in the plan: selects them by clicks and by a rectangle, has the handles that move,
 * turn and scale them, hides them in the plan, and measures distances. {@link PlanMouseController}
 * asks it before it deals with areas.
 */
final class PlanObjects {
  private final FloorPlanCanvas view;
  private final EnricherSession session;
  private final AsyncSceneQueries probe;
  private final PlacementCommands commands;
  private final ClickSelection clicks;
  private final GridSetting grid;
  private final HandleSettings settings;
  private final List<Vector3dc> measured = new ArrayList<>();
  private List<ObjectBox> boxes = List.of();

  /** The revision of the document that the boxes belong to. */
  private long revision = -1;

  private List<DocumentElement> hidden = List.of();
  private @Nullable PlanHandleDrag drag;
  private PlanHandleDrag.@Nullable Dragged dragged;

  /** A corner of the rectangle that selects, in pixels; null for none. */
  private double @Nullable [] band;

  private @Nullable Rectangle2D rectangle;

  /** Whether the rectangle adds to the selection. */
  private boolean adding;

  PlanObjects(
      FloorPlanCanvas view,
      EnricherSession session,
      AsyncSceneQueries probe,
      GridSetting grid,
      HandleSettings settings) {
    this.view = view;
    this.session = session;
    this.probe = probe;
    this.grid = grid;
    this.settings = settings;
    commands = new PlacementCommands(session, probe);
    clicks = new ClickSelection(session);
    settings.onChange(
        () -> {
          if (!settings.measuring()) {
            measured.clear();
          }
          view.repaint();
        });
    view.overlay(new PlanObjectPainter(view, this)::paint);
  }

  HandleSettings settings() {
    return settings;
  }

  PlacementCommands commands() {
    return commands;
  }

  /** The boxes of the selected nodes, as a drag has them. */
  List<ObjectBox> boxes() {
    PlanHandleDrag of = drag;
    return of != null && dragged != null ? of.objects().boxes(dragged.placements()) : boxes;
  }

  /** The words beside a dragged handle. */
  Optional<String> words() {
    return Optional.ofNullable(dragged).map(PlanHandleDrag.Dragged::words);
  }

  List<Vector3dc> measured() {
    return measured;
  }

  Optional<Rectangle2D> rectangle() {
    return Optional.ofNullable(rectangle);
  }

  /** The nodes that the plan leaves out. */
  List<DocumentElement> hidden() {
    return hidden;
  }

  /** Whether any node is selected. */
  boolean any() {
    return !session.selectedElements().isEmpty();
  }

  /** Hides the selected nodes in the plan. */
  void hide() {
    List<DocumentElement> all = new ArrayList<>(hidden);
    all.addAll(session.selectedElements());
    hidden = all.stream().filter(DocumentElement::attached).distinct().toList();
    session.select(null, view);
  }

  /** Shows all nodes again. */
  void showAll() {
    hidden = List.of();
  }

  /** Asks where the selected nodes are. */
  void follow() {
    List<DocumentElement> nodes = session.selectedElements();
    boxes = boxes.stream().filter(box -> nodes.contains(box.element())).toList();
    if (nodes.isEmpty()) {
      view.repaint();
      return;
    }
    probe.boxes(
        nodes,
        found -> {
          if (nodes.equals(session.selectedElements()) && drag == null) {
            boxes = found;
            revision = session.document().revision();
            view.repaint();
          }
        });
  }

  private Optional<PlacementDrag> objects() {
    boolean area = view.selected().isPresent();
    boolean outdated = revision != session.document().revision();
    return area || outdated || settings.measuring() || view.picture().isEmpty()
        ? Optional.empty()
        : commands.drag(boxes.stream().filter(box -> box.element().attached()).toList());
  }

  /** The handles of the selected objects. */
  List<PlanHandle> handles() {
    return drag != null
        ? List.of()
        : objects().map(of -> PlanHandle.of(of, settings.mode(), view.scale())).orElse(List.of());
  }

  Optional<PlanHandle> handle(double x, double y) {
    return handles().stream().filter(each -> each.at(x, y)).findFirst();
  }

  /** Takes a press of the left button; returns whether it does. */
  boolean press(MouseEvent event) {
    if (settings.measuring()) {
      return true;
    }
    if (event.isShiftDown() || event.isControlDown()) {
      band = new double[] {event.getX(), event.getY()};
      adding = event.isControlDown();
      return true;
    }
    Optional<PlanHandle> handle = handle(event.getX(), event.getY());
    Optional<PlacementDrag> objects = objects();
    if (handle.isPresent() && objects.isPresent()) {
      double x = view.scale().x(event.getX());
      double z = view.scale().z(event.getY());
      drag = new PlanHandleDrag(objects.get(), handle.get(), x, z);
      return true;
    }
    return false;
  }

  /** Takes a drag after {@link #press}. */
  void drag(MouseEvent event, PlanDrag.Snapping snapping) {
    PlanHandleDrag of = drag;
    if (of != null) {
      SnapGrid step = grid.step();
      dragged =
          of.at(
              view.scale().x(event.getX()),
              view.scale().z(event.getY()),
              snapping,
              step,
              event.isAltDown());
    } else if (band != null) {
      rectangle = new Rectangle2D.Double();
      rectangle.setFrameFromDiagonal(band[0], band[1], event.getX(), event.getY());
    }
    view.repaint();
  }

  /** Takes the release after {@link #press}. */
  void release(MouseEvent event, boolean still) {
    PlanHandleDrag of = drag;
    PlanHandleDrag.Dragged done = dragged;
    Rectangle2D area = rectangle;
    boolean several = band != null;
    cancel();
    if (settings.measuring()) {
      if (still) {
        measure(event);
      }
    } else if (of != null && done != null) {
      List<ObjectBox> after = of.objects().boxes(done.placements());
      if (commands.place(done.placements(), of.verb())) {
        expect(after);
      }
    } else if (still) {
      click(event, several);
    } else if (area != null) {
      select(area);
    }
    view.repaint();
  }

  private void expect(List<ObjectBox> after) {
    List<DocumentElement> now = session.selectedElements();
    List<ObjectBox> expected = new ArrayList<>();
    for (int i = 0; i < after.size() && now.size() == after.size(); i++) {
      ObjectBox box = after.get(i);
      expected.add(new ObjectBox(now.get(i), box.own(), box.place(), box.bounds()));
    }
    boxes = expected;
    revision = session.document().revision();
  }

  /** Takes a drag back; returns whether there was one. */
  boolean cancel() {
    boolean any = drag != null || band != null;
    drag = null;
    dragged = null;
    band = null;
    rectangle = null;
    return any;
  }

  private double cut() {
    return view.picture().map(FloorPlanImage::cut).orElse(0.0);
  }

  private Vector3d point(MouseEvent event) {
    return new Vector3d(view.scale().x(event.getX()), cut(), view.scale().z(event.getY()));
  }

  private void measure(MouseEvent event) {
    Vector3d from = point(event);
    probe.below(
        from,
        hidden,
        found -> {
          if (settings.measuring()) {
            if (measured.size() > 1) {
              measured.clear();
            }
            measured.add(
                new Vector3d(
                    from.x, found.map(surface -> surface.point().y()).orElse(from.y), from.z));
            view.repaint();
          }
        });
  }

  /**
   * Selects what is seen at a position, or nothing.
   *
   * @param several whether it is added to the selection, or taken away
   */
  void click(MouseEvent event, boolean several) {
    boolean innermost = event.isAltDown() || event.isControlDown() && event.isShiftDown();
    probe.below(
        point(event),
        hidden,
        found -> {
          Optional<DocumentElement> hit =
              found.flatMap(surface -> innermost ? surface.innermost() : surface.meant());
          if (hit.isEmpty()) {
            if (!several) {
              session.select(null, view);
            }
          } else if (innermost) {
            session.select(hit.get(), view);
          } else if (several) {
            clicks.toggle(hit.get(), view);
          } else {
            clicks.select(hit.get(), view);
          }
        });
  }

  /** Selects what is seen at a position, unless it is among several; then does something. */
  void select(MouseEvent event, Runnable then) {
    probe.below(
        point(event),
        hidden,
        found -> {
          found
              .flatMap(surface -> surface.meant())
              .filter(node -> !clicks.among(node))
              .ifPresent(node -> session.select(node, view));
          then.run();
        });
  }

  private void select(Rectangle2D area) {
    boolean add = adding;
    PlanTransform scale = view.scale();
    BoundingBox footprint =
        new BoundingBox(
            scale.x(area.getMinX()),
            cut(),
            scale.z(area.getMinY()),
            scale.x(area.getMaxX()),
            cut(),
            scale.z(area.getMaxY()));
    probe.within(
        footprint,
        hidden,
        found -> {
          List<DocumentElement> all = new ArrayList<>(add ? session.selectedElements() : List.of());
          all.removeAll(found);
          all.addAll(found);
          session.selectAll(all, view);
        });
  }

  /** The bounds of the selected nodes. */
  Optional<BoundingBox> selectedBounds() {
    return boxes.stream().map(ObjectBox::bounds).reduce(BoundingBox::union);
  }
}
