package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.ActionEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.AccessibleNameCheck;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What the preview shows of an open document. */
@ShowsWindows
class PreviewPanelTest extends PreviewFixture {
  @Test
  void asIfInASchemaShowsItsVersionsAndTheirPolygons() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      PreviewFrame start = window.await(frame -> middle(frame) == GREEN);
      assertThat(start.polygons()).isEqualTo(24);
      EventThread.edt(() -> window.panel.asIf(List.of("OfficeSchema", "DeskSchema")));
      PreviewFrame desk = window.await(frame -> middle(frame) == RED);
      assertThat(desk.polygons()).isGreaterThan(24);
      assertThat(desk.schemas()).containsExactly("OfficeSchema", "DeskSchema");
      EventThread.edt(() -> window.panel.asIf(List.of("DeskSchema", "OfficeSchema")));
      assertThat(window.await(frame -> middle(frame) == GREEN).polygons()).isEqualTo(24);
    }
  }

  @Test
  void whatAWallHidesIsFramedFromWhereItIsSeen() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      window.await(frame -> middle(frame) == GREEN);
      replace(
          window,
          "</Scene>",
          "<Transform translation='0 0 0.8'><Shape><Appearance><UnlitMaterial"
              + " emissiveColor='1 1 0'/></Appearance><Box size='9 9 0.1'/></Shape></Transform>"
              + "</Scene>");
      window.await(frame -> middle(frame) == 0xffff00);
      EventThread.edt(
          () ->
              window.session.select(
                  window.session.document().tree().orElseThrow().named("TrashCan").orElseThrow(),
                  window));
      window.await(frame -> frame.selected().isPresent());
      EventThread.edt(() -> act(window.panel.view(), "F"));
      PreviewFrame seen = window.await(frame -> count(frame, GREEN) > 0);
      assertThat(count(seen, GREEN)).as("pixels of the object").isGreaterThan(2000);
      assertThat(count(seen, 0xffff00)).as("pixels of the wall").isLessThan(count(seen, GREEN));
    }
  }

  @Test
  void sensorBoxesAreDrawnAndLabelledAndALabelSelectsItsSensor() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      PreviewFrame without = window.await(frame -> frame.labels().isEmpty());
      boxes(window, true);
      PreviewFrame with = window.await(frame -> !frame.labels().isEmpty());
      PreviewFrame.Label label = with.labels().get(0);
      assertThat(PreviewCanvas.text(label))
          .contains("Desk", "DeskSchema", "OfficeSchema", "12 polygons");
      int changed = 0;
      for (int y = 0; y < with.image().getHeight(); y++) {
        for (int x = 0; x < with.image().getWidth(); x++) {
          changed += with.image().getRGB(x, y) == without.image().getRGB(x, y) ? 0 : 1;
        }
      }
      assertThat(changed).as("pixels of the box").isGreaterThan(5000);
      window.screenshot("preview-boxes");
      window.click(label.x(), label.y() - 6);
      PreviewFrame selected = window.await(frame -> frame.selected().isPresent());
      assertThat(selected.labels().get(0).selected()).isTrue();
      assertThat(EventThread.get(() -> window.session.selection()).flatMap(DocumentElement::def))
          .contains("Desk");
    }
  }

  @Test
  void labelsFollowTheMetadataAndFadeBehindAWall() throws Exception {
    try (PreviewWindowDriver window = open()) {
      PreviewFrame open = window.await(frame -> !frame.labels().isEmpty());
      assertThat(open.labels().get(0).hidden()).isFalse();
      replace(window, "value='\"DeskSchema\"'", "value='\"ShelfSchema\"'");
      window.await(frame -> PreviewCanvas.text(frame.labels().get(0)).contains("ShelfSchema"));
      replace(
          window,
          "<Switch DEF='TrashCan'",
          "<Transform translation='0 0 5'><Shape><Box size='40 40 0.1'/></Shape></Transform>"
              + "<Switch DEF='TrashCan'");
      PreviewFrame behind = window.await(frame -> frame.labels().get(0).hidden());
      assertThat(PreviewCanvas.text(behind.labels().get(0))).contains("Desk");
    }
  }

  @Test
  void anEditIsShownFromWhereTheAuthorLooksAndAFaultKeepsThePicture() throws Exception {
    try (PreviewWindowDriver window = open()) {
      boxes(window, false);
      window.await(frame -> middle(frame) == GREEN);
      window.robot.mouseMove(5, 5);
      // Farther away: the object gets smaller, and stays so after the edit.
      Predicate<PreviewFrame> smooth = frame -> frame.samples() == AntiAliasing.SMOOTH;
      long near = count(window.await(frameAfter(window, "MINUS").and(smooth)), GREEN);
      replace(window, "emissiveColor='0 1 0'", "emissiveColor='1 1 0'");
      PreviewFrame edited = window.await(smooth.and(frame -> middle(frame) == 0xffff00));
      assertThat(count(edited, 0xffff00)).isBetween(near - 50, near + 50);
      replace(window, "</Switch>", "</Swich>");
      window.panel.reload();
      assertThat(EventThread.get(window.panel::message)).contains("not well formed");
      assertThat(EventThread.get(() -> window.panel.view().frame()))
          .get()
          .satisfies(kept -> assertThat(middle(kept)).isEqualTo(0xffff00));
    }
  }

  @Test
  void layersThatAreNotShownAreTold() throws Exception {
    String layers = "<LayerSet order='0 1 2'><Layer/><Layer/></LayerSet>";
    try (PreviewWindowDriver window = open()) {
      window.await(frame -> frame.otherLayers() == 0);
      replace(window, "</Scene>", layers + "</Scene>");
      window.await(frame -> frame.otherLayers() == 2);
      assertThat(EventThread.get(window.panel::message)).contains("2 other layers");
      replace(window, layers, "");
      window.await(frame -> frame.otherLayers() == 0);
      assertThat(EventThread.get(window.panel::message)).isBlank();
    }
  }

  /** Presses a key of the picture by its action and says which frame is wanted. */
  private static Predicate<PreviewFrame> frameAfter(PreviewWindowDriver window, String key) {
    PreviewCanvas view = window.panel.view();
    long before = EventThread.get(() -> count(view.frame().orElseThrow(), GREEN));
    EventThread.edt(() -> act(view, key));
    return frame -> count(frame, GREEN) < 0.9 * before; // not only smoother edges
  }

  private static void act(PreviewCanvas view, String key) {
    Object name = view.getInputMap().get(KeyStroke.getKeyStroke(key));
    view.getActionMap().get(name).actionPerformed(new ActionEvent(view, 0, key));
  }

  @Test
  void everyControlHasAnAccessibleName() throws Exception {
    try (PreviewWindowDriver window = open()) {
      EventThread.edt(() -> assertThat(AccessibleNameCheck.missing(window.panel)).isEmpty());
    }
  }

  @Test
  void disposingEndsItsThreads() throws Exception {
    Set<Thread> own;
    try (PreviewWindowDriver window = open()) {
      own = threads();
      assertThat(window.panel.isShowing()).isTrue();
      assertThat(own).extracting(Thread::getName).contains("enricher-preview");
    }
    for (Thread thread : own) {
      thread.join(TimeUnit.SECONDS.toMillis(60));
      assertThat(thread.isAlive()).as(thread.getName()).isFalse();
    }
  }

  private static Set<Thread> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith("enricher-preview"))
        .collect(Collectors.toSet());
  }

  @Test
  void theRoomIsMeasuredAndThePlanDrawnByTheRunningScene() throws Exception {
    Path scene =
        Files.writeString(
            folder.resolve("room.x3d"),
            """
            <X3D version='4.0'><Scene>
              <Viewpoint position='0 1.6 0'/>
              <Shape DEF='Room'><Box solid='false' size='6 3 4'/></Shape>
              <Transform translation='0 1.5 0'><Shape><Box solid='false' size='6 3 4'/></Shape></Transform>
              <Transform DEF='Table' translation='1 0.4 1'><Shape><Box size='1 0.8 1'/></Shape></Transform>
            </Scene></X3D>
            """);
    try (PreviewWindowDriver window = new PreviewWindowDriver(scene)) {
      window.awaitPicture();
      AsyncSceneQueries probe = window.panel.probe();
      BoundingBox room = answer(probe::room);
      assertThat(room.minX()).isCloseTo(-3, within(1e-3));
      assertThat(room.maxZ()).isCloseTo(2, within(1e-3));
      assertThat(room.height()).isCloseTo(1.5, within(1e-3));
      DocumentElement table =
          EventThread.get(() -> window.session.document().tree().orElseThrow().named("Table"))
              .orElseThrow();
      BoundingBox around = answer(answered -> probe.around(List.of(table), answered));
      assertThat(around.width()).isCloseTo(3, within(1e-3));
      assertThat(around.minY()).isLessThan(0.01);
      BoundingBox raised =
          answer(answered -> probe.raised(new BoundingBox(-2, 1, -1, -1, 1, 0), answered));
      assertThat(raised.minY()).isCloseTo(0, within(1e-3));
      assertThat(raised.maxY()).isCloseTo(1.5, within(1e-3));
      FloorPlanImage plan =
          answer(answered -> probe.plan(OptionalDouble.of(1.0), List.of(), answered));
      assertThat(plan.extent().width()).isCloseTo(6, within(1e-3));
      assertThat(plan.walls()).as("a rectangle or two").hasSizeGreaterThanOrEqualTo(16);
      int side = plan.image().getWidth();
      assertThat(plan.image().getRGB(side / 2, plan.image().getHeight() / 2) >>> 24).isEqualTo(255);
    }
  }

  private static <T> T answer(Consumer<Consumer<Optional<T>>> question) throws Exception {
    CompletableFuture<Optional<T>> answer = new CompletableFuture<>();
    EventThread.edt(() -> question.accept(answer::complete));
    return answer.get(60, TimeUnit.SECONDS).orElseThrow();
  }
}
