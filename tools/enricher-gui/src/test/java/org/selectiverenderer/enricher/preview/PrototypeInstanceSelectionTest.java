package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Prototypes' instances in the preview: what they draw stands for the ProtoInstance element. */
@ShowsWindows
class PrototypeInstanceSelectionTest extends PreviewFixture {
  private static final int YELLOW = 0xffff00;
  private static final int CYAN = 0x00ffff;
  private static final int MAGENTA = 0xff00ff;
  private static final int WHITE = 0xffffff;

  private static final String LIBRARY =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <ProtoDeclare name='Lamp'><ProtoBody><Group DEF='Foot'><Shape DEF='Bulb'><Appearance>
          <UnlitMaterial emissiveColor='1 1 1'/></Appearance><Box/></Shape></Group></ProtoBody>
        </ProtoDeclare>
      </Scene></X3D>
      """;

  private static final String SCENE =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <NavigationInfo type='"FLY"' headlight='false'/>
        <Viewpoint position='0 0 20'/>
        <ProtoDeclare name='Chair'>
          <ProtoInterface><field name='colour' type='SFColor' accessType='inputOutput'
            value='1 0 0'/></ProtoInterface>
          <ProtoBody><Transform DEF='Seat' scale='1 1 1'><Shape DEF='Leg'><Appearance>
            <UnlitMaterial><IS><connect nodeField='emissiveColor' protoField='colour'/></IS>
            </UnlitMaterial></Appearance><Box/></Shape></Transform></ProtoBody>
        </ProtoDeclare>
        <ProtoDeclare name='Pair'>
          <ProtoBody><Group><ProtoInstance name='Chair' DEF='Inner'>
            <fieldValue name='colour' value='1 0 1'/></ProtoInstance></Group></ProtoBody>
        </ProtoDeclare>
        <ProtoDeclare name='Room'>
          <ProtoInterface><field name='children' type='MFNode' accessType='inputOutput'/>
          </ProtoInterface>
          <ProtoBody><Group DEF='Walls'><IS><connect nodeField='children' protoField='children'/>
            </IS></Group></ProtoBody>
        </ProtoDeclare>
        <ExternProtoDeclare name='Lamp' url='"lamp.x3d#Lamp"'/>
        <Transform DEF='Left' translation='-6 0 0'><ProtoInstance name='Chair'/></Transform>
        <Transform DEF='Seat' translation='-2 0 0'><ProtoInstance name='Chair' DEF='Leg'>
          <fieldValue name='colour' value='0 1 0'/></ProtoInstance></Transform>
        <Transform translation='2 0 0'><ProtoInstance name='Pair'/></Transform>
        <Switch DEF='Versions' whichChoice='0'><Transform translation='6 0 0'>
          <ProtoInstance name='Chair'><fieldValue name='colour' value='0 0 1'/></ProtoInstance>
        </Transform></Switch>
        <Transform translation='-2 4 0'><ProtoInstance name='Room'><fieldValue name='children'>
          <Shape DEF='Given'><Appearance><UnlitMaterial emissiveColor='1 1 0'/></Appearance>
          <Box/></Shape></fieldValue></ProtoInstance></Transform>
        <Transform translation='2 4 0'><Inline DEF='Other' url='"other.x3d"'/></Transform>
        <Transform translation='6 4 0'><ProtoInstance name='Lamp'/></Transform>
      </Scene></X3D>
      """;

  private static final String OTHER =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <ProtoDeclare name='Desk'><ProtoBody><Shape DEF='Leg'><Appearance>
          <UnlitMaterial emissiveColor='0 1 1'/></Appearance><Box/></Shape></ProtoBody>
        </ProtoDeclare>
        <ProtoInstance name='Desk'/>
      </Scene></X3D>
      """;

  private PreviewWindowDriver scene() throws Exception {
    return scene(SCENE);
  }

  private PreviewWindowDriver scene(String text) throws Exception {
    Files.writeString(folder.resolve("lamp.x3d"), LIBRARY);
    Files.writeString(folder.resolve("other.x3d"), OTHER);
    Path scene = Files.writeString(folder.resolve("scene.x3d"), text);
    PreviewWindowDriver window = new PreviewWindowDriver(scene);
    edt(
        () -> {
          window.panel.grid(() -> SnapGrid.NONE);
          window.panel.handles(new HandleSettings());
        });
    return window;
  }

  private static PreviewFrame complete(PreviewWindowDriver window) throws Exception {
    return window.await(
        frame ->
            frame.image().getWidth() == get(() -> window.panel.view().getWidth())
                && List.of(RED, GREEN, BLUE, MAGENTA, YELLOW, CYAN, WHITE).stream()
                    .allMatch(color -> count(frame, color) > 0));
  }

  /** The middle of what is drawn in a colour. */
  private static int[] middle(PreviewFrame frame, int color) {
    long x = 0;
    long y = 0;
    for (int j = 0; j < frame.image().getHeight(); j++) {
      for (int i = 0; i < frame.image().getWidth(); i++) {
        if ((frame.image().getRGB(i, j) & 0xffffff) == color) {
          x += i;
          y += j;
        }
      }
    }
    long pixels = count(frame, color);
    return new int[] {(int) (x / pixels), (int) (y / pixels)};
  }

  /** Clicks on a colour and returns the start tag of what it selects. */
  private static String clicked(
      PreviewWindowDriver window, PreviewFrame frame, int color, boolean innermost) {
    edt(() -> window.session.select(null, window));
    int[] at = middle(frame, color);
    if (innermost) {
      window.robot.keyPress(KeyEvent.VK_CONTROL);
      window.robot.keyPress(KeyEvent.VK_SHIFT);
    }
    window.click(at[0], at[1]);
    if (innermost) {
      window.robot.keyRelease(KeyEvent.VK_SHIFT);
      window.robot.keyRelease(KeyEvent.VK_CONTROL);
    }
    window.settle();
    CompletableFuture<String> found = new CompletableFuture<>();
    window.panel.probe().around(List.of(root(window)), any -> found.complete(selected(window)));
    try {
      return found.get(60, TimeUnit.SECONDS);
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  private static DocumentElement root(PreviewWindowDriver window) {
    return get(() -> window.session.document().tree().orElseThrow().root());
  }

  private static String selected(PreviewWindowDriver window) {
    return window.session.selection().map(each -> tag(window, each)).orElse("nothing");
  }

  private static String tag(PreviewWindowDriver window, DocumentElement each) {
    return window.session.document().text(each.start(), each.tagEnd())
        + " in "
        + window
            .session
            .document()
            .text(each.parent().orElseThrow().start(), each.parent().orElseThrow().tagEnd());
  }

  @Test
  void aClickOnWhatAnInstanceDrawsSelectsTheInstanceThatIsWrittenInTheScene() throws Exception {
    try (PreviewWindowDriver window = scene()) {
      PreviewFrame frame = complete(window);
      assertThat(clicked(window, frame, RED, false))
          .as("an instance without a name, in a named Transform")
          .startsWith("<ProtoInstance name='Chair'/> in <Transform DEF='Left'");
      assertThat(clicked(window, frame, GREEN, false))
          .as("one with the name of a node in the body, in a Transform with such a name")
          .startsWith("<ProtoInstance name='Chair' DEF='Leg'>");
      assertThat(clicked(window, frame, MAGENTA, false))
          .as("the outermost of nested ones")
          .startsWith("<ProtoInstance name='Pair'/> in <Transform");
      assertThat(clicked(window, frame, BLUE, false))
          .as("one in a version")
          .startsWith("<Switch DEF='Versions'");
      assertThat(clicked(window, frame, BLUE, true))
          .startsWith("<ProtoInstance name='Chair'> in <Transform translation='6 0 0'>");
      assertThat(clicked(window, frame, YELLOW, false))
          .as("a node given to a field is written in the scene")
          .startsWith("<Shape DEF='Given'>");
      assertThat(clicked(window, frame, CYAN, false))
          .as("one in an inlined file")
          .startsWith("<Inline DEF='Other'");
      assertThat(clicked(window, frame, WHITE, false))
          .as("one of another file's prototype")
          .startsWith("<ProtoInstance name='Lamp'/>");
    }
  }

  @Test
  void aSelectedInstanceIsOutlinedMeasuredAndAddedToOthersByClicks() throws Exception {
    try (PreviewWindowDriver window = scene()) {
      PreviewFrame frame = complete(window);
      edt(() -> window.session.select(instance(window, "<ProtoInstance name='Chair'/>"), window));
      PreviewFrame outlined = window.await(each -> each.boxes().size() == 1);
      assertThat(outlined.boxes().get(0).bounds().minX()).isBetween(-7.01, -6.99);
      assertThat(count(outlined, OUTLINE)).isPositive();
      int[] at = middle(frame, WHITE);
      window.robot.keyPress(KeyEvent.VK_CONTROL);
      window.click(at[0], at[1]);
      window.robot.keyRelease(KeyEvent.VK_CONTROL);
      PreviewFrame both = window.await(each -> each.boxes().size() == 2);
      assertThat(both.boxes().stream().map(box -> tag(window, box.element())))
          .allMatch(each -> each.startsWith("<ProtoInstance"));
    }
  }

  @Test
  void theHandlesPutATransformAroundAnInstance() throws Exception {
    String lamp = "<ProtoInstance name='Lamp'/>";
    String text = SCENE.replace("<Transform translation='6 4 0'>" + lamp + "</Transform>", lamp);
    try (PreviewWindowDriver window = scene(text)) {
      complete(window);
      edt(() -> window.session.select(instance(window, lamp), window));
      PreviewFrame frame = window.await(each -> each.boxes().size() == 1);
      BoundingBox bounds = frame.boxes().get(0).bounds();
      Vector3d pivot = bounds.min().add(bounds.max()).mul(0.5);
      PictureRays rays = new PictureRays(frame.camera());
      Vector2d arrow =
          rays.project(new Vector3d(pivot).add(56 * rays.pixel(pivot), 0, 0)).orElseThrow();
      window.drag((int) arrow.x, (int) arrow.y, (int) arrow.x + 40, (int) arrow.y);
      window.drop();
      PreviewFrame after =
          window.await(
              each ->
                  each.revision() > 0
                      && each.boxes().size() == 1
                      && each.boxes().get(0).bounds().minX() > -0.9);
      assertThat(after.boxes().get(0).bounds().minY()).isBetween(-1.01, -0.99);
      assertThat(get(() -> window.session.document().text().toString()))
          .containsPattern("<Transform translation='[0-9.]+ 0 0'>\\s*<ProtoInstance name='Lamp'/>");
    }
  }

  @Test
  void thePlanFindsInstancesByARectangle() throws Exception {
    try (PreviewWindowDriver window = scene()) {
      complete(window);
      CompletableFuture<List<DocumentElement>> found = new CompletableFuture<>();
      edt(
          () ->
              window
                  .panel
                  .probe()
                  .within(new BoundingBox(-8, 10, -2, 8, 10, 2), List.of(), found::complete));
      List<String> tags = new ArrayList<>();
      for (DocumentElement each : found.get(60, TimeUnit.SECONDS)) {
        tags.add(get(() -> window.session.document().text(each.start(), each.tagEnd())));
      }
      assertThat(tags)
          .containsExactlyInAnyOrder(
              "<ProtoInstance name='Chair'/>",
              "<ProtoInstance name='Chair' DEF='Leg'>",
              "<ProtoInstance name='Pair'/>",
              "<Switch DEF='Versions' whichChoice='0'>",
              "<Shape DEF='Given'>",
              "<Inline DEF='Other' url='\"other.x3d\"'/>",
              "<ProtoInstance name='Lamp'/>");
    }
  }

  private static DocumentElement instance(PreviewWindowDriver window, String startTag) {
    return window.session.document().tree().orElseThrow().instances().stream()
        .filter(
            each -> window.session.document().text(each.start(), each.tagEnd()).equals(startTag))
        .findFirst()
        .orElseThrow();
  }
}
