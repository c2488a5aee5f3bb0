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
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.authoring.placement.Arrangement;
import org.selectiverenderer.authoring.placement.TransformPose;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.area.GridSetting;
import org.selectiverenderer.enricher.area.NamePrompt;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.area.SurfacePoint;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.PlacementCommands;
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
  private final class Room implements AsyncSceneQueries {
    @Override
    public void around(List<DocumentElement> elements, Consumer<Optional<BoundingBox>> answer) {
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
      leftOut = hidden;
      BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_ARGB);
      float[] walls = {-4, -4, -4, 4, 4, -4, 4, 4};
      answer.accept(Optional.of(new FloorPlanImage(ROOM, image, walls, 1)));
    }

    /** Half a metre wide and a metre high, at the translation of its Transform. */
    private static ObjectBox box(DocumentElement node) {
      TransformPose pose = TransformPose.of(node);
      BoundingBox own = new BoundingBox(-0.25, 0, -0.25, 0.25, 1, 0.25);
      return new ObjectBox(node, own, pose.matrix(), own.transformed(pose.matrix()));
    }

    private List<ObjectBox> all(List<DocumentElement> hidden) {
      return session.document().tree().orElseThrow().scene().orElseThrow().children().stream()
          .filter(node -> node.name().equals("Transform") && !hidden.contains(node))
          .map(Room::box)
          .toList();
    }

    @Override
    public void boxes(List<DocumentElement> nodes, Consumer<List<ObjectBox>> answer) {
      answer.accept(
          nodes.stream().filter(node -> node.name().equals("Transform")).map(Room::box).toList());
    }

    @Override
    public void below(
        Vector3dc from, List<DocumentElement> hidden, Consumer<Optional<SurfacePoint>> answer) {
      answer.accept(
          all(hidden).stream()
              .filter(box -> box.bounds().contains(new Vector3d(from.x(), 0.5, from.z())))
              .findFirst()
              .map(
                  box ->
                      new SurfacePoint(
                          new Vector3d(from.x(), 1, from.z()),
                          Optional.of(box.element()),
                          Optional.of(box.element()))));
    }

    @Override
    public void within(
        BoundingBox footprint,
        List<DocumentElement> hidden,
        Consumer<List<DocumentElement>> answer) {
      answer.accept(
          all(hidden).stream()
              .filter(
                  box ->
                      box.bounds().minX() >= footprint.minX()
                          && box.bounds().maxX() <= footprint.maxX()
                          && box.bounds().minZ() >= footprint.minZ()
                          && box.bounds().maxZ() <= footprint.maxZ())
              .map(ObjectBox::element)
              .toList());
    }

    @Override
    public void support(List<ObjectBox> boxes, Consumer<List<OptionalDouble>> answer) {
      answer.accept(boxes.stream().map(box -> OptionalDouble.of(0)).toList());
    }
  }

  /** What the last plan left out. */
  private List<DocumentElement> leftOut = List.of();

  private final HandleSettings handles = new HandleSettings();
  private EnricherSession session;
  private PlanPanel panel;
  private FloorPlanCanvas view;

  /** What is drawn while a name is asked for. */
  private final List<Optional<BoundingBox>> whileAsked = new ArrayList<>();

  private void open(String nodes) throws Exception {
    openWithoutPlan(nodes);
    EventThread.edt(
        () ->
            new Room()
                .plan(OptionalDouble.empty(), List.of(), plan -> view.show(plan.orElseThrow())));
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
                  session,
                  new AreaCommands(session, new Room(), question),
                  question,
                  grid,
                  handles);
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
    mouse(kind, x, z, 0);
  }

  private void mouse(int kind, double x, double z, int keys) {
    PlanTransform scale = view.scale();
    boolean down = kind != MouseEvent.MOUSE_RELEASED;
    view.dispatchEvent(
        new MouseEvent(
            view,
            kind,
            0,
            keys | (down ? InputEvent.BUTTON1_DOWN_MASK : 0),
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

  private static final String CHAIRS =
      """
      <Transform DEF='A' translation='-2 0 1'><Shape/></Transform>
      <Transform DEF='B' translation='1 0 2'><Shape/></Transform>
      <Transform DEF='C' translation='2 0 -1'><Shape/></Transform>
      """;

  private void click(double x, double z, int keys) {
    mouse(MouseEvent.MOUSE_PRESSED, x, z, keys);
    mouse(MouseEvent.MOUSE_RELEASED, x, z, keys);
  }

  private List<String> selected() {
    return session.selectedElements().stream().map(each -> each.def().orElse("")).toList();
  }

  private String nodes() {
    String text = session.document().text().toString();
    return text.substring(text.indexOf("<Transform DEF='A'"), text.lastIndexOf("</Scene>"));
  }

  @Test
  void objectsAreSelectedByClicksAndARectangleMovedByTheirHandleAndTakenBack() throws Exception {
    open(CHAIRS);
    EventThread.edt(
        () -> {
          click(-2, 1, 0);
          assertThat(selected()).containsExactly("A");
          click(1, 2, InputEvent.CTRL_DOWN_MASK);
          assertThat(selected()).containsExactly("A", "B");
          click(-3, -3, 0);
          assertThat(selected()).isEmpty();
          mouse(MouseEvent.MOUSE_PRESSED, 0, -2, InputEvent.SHIFT_DOWN_MASK);
          mouse(MouseEvent.MOUSE_DRAGGED, 3, 3, InputEvent.SHIFT_DOWN_MASK);
          mouse(MouseEvent.MOUSE_RELEASED, 3, 3, InputEvent.SHIFT_DOWN_MASK);
          assertThat(selected()).containsExactly("B", "C");
          click(-2, 1, 0);
          drag(-2, 1, -1.52, 0.97);
          key("ESCAPE");
          mouse(MouseEvent.MOUSE_RELEASED, -1.52, 0.97);
          assertThat(nodes()).isEqualTo(CHAIRS);
          drag(-2, 1, -1.52, 0.97);
          mouse(MouseEvent.MOUSE_RELEASED, -1.52, 0.97);
          assertThat(nodes()).as("on the grid").contains("DEF='A' translation='-1.55 0 0.95'");
          assertThat(session.document().history().names()).hasSize(1);
          assertThat(selected()).containsExactly("A");
          assertThat(areas()).isEmpty();
          key("RIGHT");
          assertThat(nodes()).contains("DEF='A' translation='-1.45 0 0.95'");
        });
  }

  @Test
  void theRingTurnsAndASideStretches() throws Exception {
    open(CHAIRS);
    EventThread.edt(
        () -> {
          click(1, 2, 0);
          key("T");
          double radius = PlanHandle.LENGTH / view.scale().scale();
          drag(1 + radius, 2, 1 + 0.01, 2 - radius);
          mouse(MouseEvent.MOUSE_RELEASED, 1 + 0.01, 2 - radius);
          assertThat(nodes())
              .contains("<Transform DEF='B' translation='1 0 2' rotation='0 1 0 1.570796'>");
          session.document().history().undo();
          assertThat(panel.objects().handles()).as("where the objects are is not known").isEmpty();
          panel.objects().follow();
          key("S");
          drag(1.25, 2, 1.76, 2);
          mouse(MouseEvent.MOUSE_RELEASED, 1.76, 2);
          assertThat(nodes()).contains("<Transform DEF='B' translation='1.25 0 2' scale='2 1 1'>");
        });
  }

  @Test
  void objectsAreHiddenInThePlanAloneAndShownAgain() throws Exception {
    open(CHAIRS);
    EventThread.edt(
        () -> {
          click(1, 2, 0);
          PlanObjects objects = panel.objects();
          objects.hide();
          assertThat(objects.hidden()).extracting(each -> each.def().orElse("")).contains("B");
          assertThat(nodes()).isEqualTo(CHAIRS);
          click(1, 2, 0);
          assertThat(selected()).as("what is hidden is not hit").isEmpty();
          objects.showAll();
          click(1, 2, 0);
          assertThat(selected()).containsExactly("B");
        });
  }

  @Test
  void distancesAreMeasuredAndTheBarSaysARoundLength() throws Exception {
    open(CHAIRS);
    EventThread.edt(
        () -> {
          key("D");
          click(-2, 1, 0);
          click(1, 1, 0);
          assertThat(panel.objects().measured()).hasSize(2);
          assertThat(panel.objects().measured().get(0).y()).as("on the chair").isEqualTo(1);
          assertThat(selected()).isEmpty();
          key("ESCAPE");
          assertThat(panel.objects().measured()).isEmpty();
        });
    assertThat(ScaleBar.of(100).metres()).isEqualTo(0.5);
    assertThat(ScaleBar.of(40).metres()).isEqualTo(2);
    assertThat(ScaleBar.of(7).pixels()).isBetween(50.0, 130.0);
    assertThat(ScaleBar.of(40).words()).isEqualTo("2 m");
  }

  @Test
  void selectedObjectsAreArrangedGroupedAndUngrouped() throws Exception {
    open(CHAIRS);
    EventThread.edt(
        () -> {
          PlacementCommands commands = panel.objects().commands();
          click(-2, 1, 0);
          click(1, 2, InputEvent.CTRL_DOWN_MASK);
          click(2, -1, InputEvent.CTRL_DOWN_MASK);
          commands.align(2, Arrangement.Side.LOWER);
          assertThat(nodes()).contains("'-2 0 -1'").contains("'1 0 -1'").contains("'2 0 -1'");
          commands.distribute(0);
          assertThat(nodes()).contains("DEF='B' translation='0 0 -1'");
          assertThat(selected()).containsExactly("A", "B", "C");
          commands.putOnFloor();
          assertThat(session.document().history().names()).as("they stand on it").hasSize(2);
          commands.group();
          assertThat(selected()).containsExactly("Group");
          commands.ungroup();
          assertThat(selected()).containsExactly("A", "B", "C");
          session.document().history().undo();
          session.document().history().undo();
          session.document().history().undo();
          session.document().history().undo();
          assertThat(nodes()).isEqualTo(CHAIRS);
        });
  }
}
