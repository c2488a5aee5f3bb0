package org.selectiverenderer.enricher.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.area.NamePrompt;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.area.SurfacePoint;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The plan without a window: mouse events as Swing sends them. */
@RequiresDisplay
class PlanPanelTest {
  private static final BoundingBox ROOM = new BoundingBox(-4, 0, -4, 4, 3, 4);

  @TempDir Path folder;

  /** A room 8 m wide with a ceiling at 3 m. */
  private static final class Room implements AsyncSceneQueries {
    @Override
    public void around(DocumentElement element, Consumer<Optional<BoundingBox>> answer) {
      answer.accept(Optional.empty());
    }

    @Override
    public void room(Consumer<Optional<BoundingBox>> answer) {
      answer.accept(Optional.of(ROOM));
    }

    @Override
    public void raised(BoundingBox of, Consumer<Optional<BoundingBox>> answer) {
      answer.accept(Optional.of(new BoundingBox(of.minX(), 0, of.minZ(), of.maxX(), 3, of.maxZ())));
    }

    @Override
    public void plan(
        OptionalDouble cut,
        List<DocumentElement> hidden,
        Consumer<Optional<FloorPlanImage>> answer) {
      BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_ARGB);
      float[] walls = {-4, -4, -4, 4, 4, -4, 4, 4};
      answer.accept(Optional.of(new FloorPlanImage(ROOM, image, walls, 1)));
    }

    @Override
    public void boxes(List<DocumentElement> nodes, Consumer<List<ObjectBox>> answer) {
      answer.accept(List.of());
    }

    @Override
    public void below(
        Vector3dc from, List<DocumentElement> hidden, Consumer<Optional<SurfacePoint>> answer) {
      answer.accept(Optional.empty());
    }

    @Override
    public void within(
        BoundingBox footprint,
        List<DocumentElement> hidden,
        Consumer<List<DocumentElement>> answer) {
      answer.accept(List.of());
    }

    @Override
    public void support(List<ObjectBox> boxes, Consumer<List<OptionalDouble>> answer) {
      answer.accept(boxes.stream().map(box -> OptionalDouble.of(0)).toList());
    }
  }

  private EnricherSession session;
  private PlanPanel panel;
  private FloorPlanCanvas view;

  /** What is drawn while a name is asked for. */
  private final List<Optional<BoundingBox>> whileAsked = new ArrayList<>();

  private void open(String nodes) throws Exception {
    openWithoutPlan(nodes);
    EventThread.edt(() -> new Room().plan(OptionalDouble.empty(), List.of(), plan -> view.show(plan.orElseThrow())));
  }

  private void openWithoutPlan(String nodes) throws Exception {
    session = TestSessions.with(folder, nodes);
    NamePrompt question =
        (title, proposal, complaint) -> {
          whileAsked.add(view.drawing());
          return Optional.of(proposal);
        };
    GridSetting grid = new GridSetting(new EnricherSettings(folder));
    EventThread.edt(
        () -> {
          panel =
              new PlanPanel(
                  session, new AreaCommands(session, new Room(), question), question, grid);
          panel.setSize(800, 700);
          panel.doLayout();
          for (Component each : panel.getComponents()) {
            if (each instanceof FloorPlanCanvas found) {
              view = found;
            }
          }
        });
  }

  private void mouse(int kind, double x, double z) {
    PlanTransform scale = view.scale();
    boolean down = kind != MouseEvent.MOUSE_RELEASED;
    view.dispatchEvent(
        new MouseEvent(
            view,
            kind,
            0,
            down ? InputEvent.BUTTON1_DOWN_MASK : 0,
            (int) Math.round(scale.toX(x)),
            (int) Math.round(scale.toY(z)),
            1,
            false,
            kind == MouseEvent.MOUSE_DRAGGED ? MouseEvent.NOBUTTON : MouseEvent.BUTTON1));
  }

  private void drag(double x, double z, double toX, double toZ) {
    mouse(MouseEvent.MOUSE_PRESSED, x, z);
    mouse(MouseEvent.MOUSE_DRAGGED, (x + toX) / 2, (z + toZ) / 2);
    mouse(MouseEvent.MOUSE_DRAGGED, toX, toZ);
  }

  private void key(String stroke) {
    Object action = view.getInputMap(JComponent.WHEN_FOCUSED).get(KeyStroke.getKeyStroke(stroke));
    view.getActionMap().get(action).actionPerformed(null);
  }

  private String areas() {
    StringBuilder all = new StringBuilder();
    AreaLocator.of(session.enrichment())
        .forEach(
            area -> {
              BoundingBox b = area.box().bounds();
              all.append(
                  "%s %.1f..%.1f %.1f..%.1f %.1f..%.1f; "
                      .formatted(
                          area.name(), b.minX(), b.maxX(), b.minY(), b.maxY(), b.minZ(), b.maxZ()));
            });
    return all.toString();
  }

  @Test
  void nothingIsDrawnBeforeThePlanIsThere() throws Exception {
    openWithoutPlan("<Group/>\n");
    EventThread.edt(
        () -> {
          assertThat(view.getAccessibleContext().getAccessibleDescription())
              .isEqualTo(Texts.of("area.plan.empty"));
          drag(-1, -1, 1, 1);
          assertThat(view.drawing()).isEmpty();
          mouse(MouseEvent.MOUSE_RELEASED, 1, 1);
          new Room().plan(OptionalDouble.empty(), List.of(), plan -> view.show(plan.orElseThrow()));
          assertThat(view.getAccessibleContext().getAccessibleDescription()).isEmpty();
        });
    assertThat(whileAsked).isEmpty();
    assertThat(areas()).isEmpty();
  }

  @Test
  void anAreaIsDrawnFromFloorToCeilingMovedToTheWallResizedAndTakenBack() throws Exception {
    open("<Group/>\n");
    EventThread.edt(
        () -> {
          drag(-1.02, -1.98, 1.03, 1.01);
          mouse(MouseEvent.MOUSE_RELEASED, 1.03, 1.01);
          assertThat(areas()).isEqualTo("Area -1.0..1.0 0.0..3.0 -2.0..1.0; ");
          assertThat(view.selected()).as("is chosen").isPresent();
          drag(0.3, 0.3, 3.25, 0.3);
          mouse(MouseEvent.MOUSE_RELEASED, 3.25, 0.3);
          assertThat(areas()).as("at the wall").isEqualTo("Area 2.0..4.0 0.0..3.0 -2.0..1.0; ");
          drag(2, 1, 1.5, 2.02);
          mouse(MouseEvent.MOUSE_RELEASED, 1.5, 2.02);
          assertThat(areas()).as("by a corner").isEqualTo("Area 1.5..4.0 0.0..3.0 -2.0..2.0; ");
          drag(3, 0, 0, 0);
          key("ESCAPE");
          mouse(MouseEvent.MOUSE_DRAGGED, -1, 0);
          mouse(MouseEvent.MOUSE_RELEASED, -1, 0);
          assertThat(session.document().history().names())
              .containsExactly("Add the area Area", "Move Area", "Resize Area");
        });
  }

  @Test
  void whatWasDrawnIsSeenWhileItsNameIsAskedForAndNoLonger() throws Exception {
    open("<Group/>\n");
    EventThread.edt(
        () -> {
          drag(-1, -2, 1, 1);
          mouse(MouseEvent.MOUSE_RELEASED, 1, 1);
          assertThat(whileAsked)
              .singleElement()
              .satisfies(
                  drawn -> assertThat(drawn.orElseThrow().width()).isCloseTo(2, within(0.01)));
          assertThat(view.drawing()).isEmpty();
        });
  }

  @Test
  void allOfThePlanStaysInViewWhenTheWindowChangesUnlessTheAuthorCameNearer() throws Exception {
    open("<Group/>\n");
    EventThread.edt(
        () -> {
          double wide = view.scale().scale();
          view.setSize(view.getWidth() / 3, view.getHeight());
          assertThat(view.scale().toX(ROOM.minX())).isGreaterThanOrEqualTo(0);
          assertThat(view.scale().toX(ROOM.maxX())).isLessThanOrEqualTo(view.getWidth());
          double narrow = view.scale().scale();
          assertThat(narrow).isLessThan(wide);
          view.scale(view.scale().zoomed(2, 0, 0));
          view.setSize(view.getWidth() * 3, view.getHeight());
          assertThat(view.scale().scale()).isCloseTo(2 * narrow, within(1e-9));
        });
  }

  @Test
  void keysCopyMoveAndDeleteAreas() throws Exception {
    open("<ProximitySensor DEF='A' center='0 1.5 0' size='2 3 2'/>\n");
    EventThread.edt(
        () -> {
          key("PAGE_DOWN");
          key("ctrl C");
          key("ctrl V");
          assertThat(areas())
              .isEqualTo("A -1.0..1.0 0.0..3.0 -1.0..1.0; A_2 -0.5..1.5 0.0..3.0 -0.5..1.5; ");
          key("RIGHT");
          assertThat(areas()).contains("A_2 -0.4..1.6");
          key("PAGE_UP");
          key("DELETE");
          assertThat(areas()).startsWith("A_2 ");
          drag(-3, -3, -3, -3);
          mouse(MouseEvent.MOUSE_RELEASED, -3, -3);
          assertThat(session.selection()).as("a click beside all").isEmpty();
        });
  }
}
