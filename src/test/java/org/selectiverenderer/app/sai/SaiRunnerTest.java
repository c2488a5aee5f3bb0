package org.selectiverenderer.app.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.sai.EmbeddedBrowserFactory;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.web3d.x3d.sai.BrowserFactoryImpl;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.InvalidURLException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.navigation.NavigationInfo;
import org.web3d.x3d.sai.navigation.Viewpoint;

/** The controller in a browser of which it knows the SAI only: here the embedded one. */
class SaiRunnerTest {
  private static final String SCENE =
      """
      <X3D version='3.3' profile='Immersive'><Scene>
        <Viewpoint DEF='V' position='0 0 6'/>
        <ProximitySensor DEF='Desk' size='2 2 2'><MetadataSet containerField='metadata'>
          <MetadataString containerField='value' name='enterTimeSchema' value='"Near"'/>
          <MetadataString containerField='value' name='exitTimeSchema' value='"Far"'/>
        </MetadataSet></ProximitySensor>
        <Switch DEF='Can' whichChoice='1'><MetadataSet containerField='metadata'>
          <MetadataSet containerField='value'><MetadataString containerField='value'
            name='schemaBelonginess' value='"Near"'/></MetadataSet>
          <MetadataSet containerField='value'><MetadataString containerField='value'
            name='schemaBelonginess' value='"Far"'/></MetadataSet>
        </MetadataSet><Shape><Box/></Shape><Shape><Sphere/></Shape></Switch>
      </Scene></X3D>
      """;

  private @TempDir Path dir;
  private final List<TimelineEvent> events = new CopyOnWriteArrayList<>();
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();

  private Path scene() throws IOException {
    return Files.writeString(dir.resolve("scene.x3d"), SCENE);
  }

  private String next() throws InterruptedException {
    String line = lines.poll(30, TimeUnit.SECONDS);
    assertThat(line).isNotNull();
    return line;
  }

  @Test
  void walkingThroughTheSaiSwitchesAndTellsSo() throws Exception {
    try (SaiRunner runner =
        SaiRunner.open(
            scene().toUri().toString(), Settings.SELECTIVE, Map.of(), lines::add, events::add)) {
      assertThat(next()).startsWith("browser: Selective Renderer");
      assertThat(next()).contains("start", "no Switch"); // the empty scene before
      assertThat(next()).contains("start", "Can: choice 1");
      assertThat(runner.showWindow(() -> {})).isFalse();
      X3DScene scene = (X3DScene) runner.browser().getExecutionContext();
      Viewpoint viewpoint = (Viewpoint) scene.getNamedNode("V");
      viewpoint.setPosition(new float[] {0, 0, 0});
      assertThat(next()).contains("enter", "Desk activates Near");
      assertThat(next()).contains("switch", "Can: choice 1 -> 0 (Near)");
      viewpoint.setPosition(new float[] {0, 0, 6});
      assertThat(next()).contains("exit", "Desk activates Far");
      assertThat(next()).contains("switch", "Can: choice 0 -> 1 (Far)");
    }
  }

  @Test
  void aPathMovesTheViewerAndTheTimeLineIsWritten() throws Exception {
    Path path = Files.writeString(dir.resolve("p.csv"), "t,x,y,z\n0,0,0,6\n0.5,0,0,0\n1,0,0,6\n");
    Path timeline = dir.resolve("t.jsonl");
    Process walk =
        process(
                EmbeddedBrowserFactory.class.getName(),
                "--path",
                path.toString(),
                "--timeline",
                timeline.toString())
            .start();
    String printed = output(walk);
    assertThat(walk.exitValue()).as(printed).isZero();
    assertThat(Files.readAllLines(timeline))
        .extracting(line -> line.replaceAll("\"t\":[0-9.]+,", ""))
        .containsExactly(
            "{\"event\":\"start\",\"switches\":{\"Can\":1}}",
            "{\"event\":\"enter\",\"sensor\":\"Desk\",\"schemas\":[\"Near\"]}",
            "{\"event\":\"switch\",\"switch\":\"Can\",\"from\":1,\"to\":0,\"schema\":\"Near\"}",
            "{\"event\":\"exit\",\"sensor\":\"Desk\",\"schemas\":[\"Far\"]}",
            "{\"event\":\"switch\",\"switch\":\"Can\",\"from\":0,\"to\":1,\"schema\":\"Far\"}");
  }

  @Test
  void anExportedSceneIsOnlyObservedAndItsOwnScriptSwitches() throws Exception {
    Path exported = dir.resolve("exported");
    Process export =
        java(
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "export",
                scene().toString(),
                "--to",
                "x3d",
                exported.toString())
            .start();
    assertThat(output(export)).contains("scene.x3d");
    Path path = Files.writeString(dir.resolve("p.csv"), "t,x,y,z\n0,0,0,6\n0.5,0,0,0\n1,0,0,6\n");
    Path timeline = dir.resolve("t.jsonl");
    Process walk =
        java(
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "sai",
                exported.resolve("scene.x3d").toString(),
                "--observe",
                "--path",
                path.toString(),
                "--timeline",
                timeline.toString())
            .start();
    assertThat(output(walk)).contains("switch  Can: choice 1 -> 0\n");
    assertThat(Files.readAllLines(timeline))
        .extracting(line -> line.replaceAll("\"t\":[0-9.]+,", ""))
        .containsExactly(
            "{\"event\":\"start\",\"switches\":{\"Can\":1}}",
            "{\"event\":\"enter\",\"sensor\":\"Desk\",\"schemas\":[\"Near\"]}",
            "{\"event\":\"switch\",\"switch\":\"Can\",\"from\":1,\"to\":0,\"schema\":\"\"}",
            "{\"event\":\"exit\",\"sensor\":\"Desk\",\"schemas\":[\"Far\"]}",
            "{\"event\":\"switch\",\"switch\":\"Can\",\"from\":0,\"to\":1,\"schema\":\"\"}");

    Process both =
        process(EmbeddedBrowserFactory.class.getName(), "--observe", "--condition", "high").start();
    assertThat(output(both)).contains("leave out --condition");
    assertThat(both.exitValue()).isEqualTo(2);
  }

  @Test
  void theViewerOfAPathSeesWhatTheSceneWantsSeen() throws Exception {
    Path scene =
        Files.writeString(
            scene(),
            SCENE
                .replace("position='0 0 6'", "position='0 0 6' fieldOfView='0.5'")
                .replace(
                    "<Viewpoint",
                    "<NavigationInfo headlight='false' visibilityLimit='60' avatarSize='0.1 1 0.2'/>"
                        + "<Viewpoint"));
    Path path = Files.writeString(dir.resolve("p.csv"), "t,x,y,z\n0,0,0,6\n1,0,0,0\n");
    CameraPath read = CameraPathReader.read(path, new ProblemCollector()).orElseThrow();
    try (SaiRunner runner =
        SaiRunner.open(
            scene.toUri().toString(), Settings.SELECTIVE, Map.of(), lines::add, events::add)) {
      assertThat(next()).startsWith("browser: ");
      assertThat(next()).contains("no Switch");
      assertThat(next()).contains("Can: choice 1");
      runner.follow(read, new CountDownLatch(0)); // It ends at once.
      X3DNode[] roots = ((X3DScene) runner.browser().getExecutionContext()).getRootNodes();
      NavigationInfo navigation = (NavigationInfo) roots[roots.length - 2];
      float[] avatar = new float[3];
      navigation.getAvatarSize(avatar);
      assertThat(navigation.getHeadlight()).isFalse();
      assertThat(navigation.getVisibilityLimit()).isEqualTo(60);
      assertThat(avatar).containsExactly(0.1f, 1, 0.2f);
      assertThat(((Viewpoint) roots[roots.length - 1]).getFieldOfView()).isEqualTo(0.5f);
    }
  }

  @Test
  void aPathBeginsWhenTheSceneIsUnderControlHoweverLateTheBrowserSaysSo() throws Exception {
    Path path = Files.writeString(dir.resolve("p.csv"), "t,x,y,z\n0,0,0,6\n0.3,0,0,0\n");
    Process walk =
        process(DelayedBrowserFactory.class.getName(), "--path", path.toString()).start();
    assertThat(output(walk).lines().map(line -> line.replaceFirst("^ *[0-9.]+ s  ", "")))
        .containsSubsequence(
            "start   Can: choice 1",
            "enter   Desk activates Near",
            "switch  Can: choice 1 -> 0 (Near)")
        .doesNotContain(DelayedBrowserFactory.TOO_EARLY);
    assertThat(walk.exitValue()).isZero();
  }

  @Test
  void aSceneThatIsNotThereEndsTheBrowserAgain() {
    String missing = dir.resolve("no.x3d").toUri().toString();
    assertThatThrownBy(
            () -> SaiRunner.open(missing, Settings.SELECTIVE, Map.of(), lines::add, events::add))
        .isInstanceOf(InvalidURLException.class);
  }

  @Test
  void theBrowserIsChosenByASystemPropertyAndEndsWithStandardInput() throws Exception {
    Process good = process(EmbeddedBrowserFactory.class.getName()).start();
    assertThat(output(good)).contains("browser: Selective Renderer", "Can: choice 1");
    assertThat(good.exitValue()).isZero();

    Process bad = process("org.xj3d.NotThere").start();
    assertThat(output(bad)).contains("the browser factory org.xj3d.NotThere cannot be used");
    assertThat(bad.exitValue()).isEqualTo(2);
  }

  @Test
  @ShowsWindows
  void aBrowserThatIsASwingPanelRunsInAWindowUntilTheWindowIsClosed() throws Exception {
    Process panel =
        process(
                PanelBrowserFactory.class.getName(),
                "--sai-parameter",
                "Xj3D_DisableAudio=FALSE",
                "--sai-parameter",
                "Skin=blue")
            .start();
    assertThat(output(panel))
        .contains("Xj3D_DisableAudio=false", "Skin=blue", "Can: choice 1", "shown: true");
    assertThat(panel.exitValue()).isZero();
  }

  @Test
  @EnabledOnOs(OS.LINUX) // Elsewhere there always is a display.
  void aBrowserThatNeedsADisplaySaysSoWhereThereIsNone() throws Exception {
    ProcessBuilder builder = process(PanelBrowserFactory.class.getName());
    builder.environment().remove("DISPLAY");
    Process panel = builder.start();
    assertThat(output(panel))
        .contains("the browser does not start: it opens a window, but Java finds no display");
    assertThat(panel.exitValue()).isEqualTo(2);
  }

  @Test
  void aBrowserWithoutItsLibrariesSaysWhatItLacks() throws Exception {
    Process broken = process(BrokenFactory.class.getName()).start();
    assertThat(output(broken))
        .contains("the browser does not start", "no sound library")
        .doesNotContain("internal error");
    assertThat(broken.exitValue()).isEqualTo(2);
  }

  @Test
  void aSceneThatTheBrowserRefusesInItsOwnWayIsNoErrorOfOurs() throws Exception {
    Process refusing = process(RefusingFactory.class.getName()).start();
    assertThat(output(refusing))
        .contains("the browser cannot read the scene", "no profile Full")
        .doesNotContain("internal error");
    assertThat(refusing.exitValue()).isEqualTo(2);
  }

  /** Refuses every scene with an exception that the SAI does not know, as Xj3D does some. */
  public static final class RefusingFactory implements BrowserFactoryImpl {
    @Override
    public X3DComponent createComponent(Map<String, Object> parameters) {
      X3DComponent embedded = new EmbeddedBrowserFactory().createComponent(parameters);
      return answering(
          X3DComponent.class,
          embedded,
          "getBrowser",
          () ->
              answering(
                  ExternalBrowser.class,
                  embedded.getBrowser(),
                  "createX3DFromURL",
                  () -> {
                    throw new IllegalStateException("no profile Full");
                  }));
    }

    private static <T> T answering(Class<T> type, T other, String name, Supplier<?> answer) {
      return type.cast(
          Proxy.newProxyInstance(
              type.getClassLoader(),
              new Class<?>[] {type},
              (proxy, method, arguments) ->
                  method.getName().equals(name) ? answer.get() : method.invoke(other, arguments)));
    }

    @Override
    public ExternalBrowser getBrowser(InetAddress address, int port) {
      throw new NotSupportedException("browsers on other machines");
    }
  }

  /** Fails as Xj3D does when a class of it cannot begin. */
  public static final class BrokenFactory implements BrowserFactoryImpl {
    @Override
    public X3DComponent createComponent(Map<String, Object> parameters) {
      throw new ExceptionInInitializerError(new IllegalStateException("no sound library"));
    }

    @Override
    public ExternalBrowser getBrowser(InetAddress address, int port) {
      throw new NotSupportedException("browsers on other machines");
    }
  }

  private ProcessBuilder process(String factory, String... options) throws IOException {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "-Dx3d.sai.factory.class=" + factory,
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "sai",
                scene().toString()));
    arguments.addAll(List.of(options));
    return java(arguments.toArray(String[]::new));
  }

  private static ProcessBuilder java(String... arguments) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command).redirectErrorStream(true);
  }

  private static String output(Process process) throws Exception {
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
    return text;
  }
}
