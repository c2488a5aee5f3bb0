package org.selectiverenderer.cli.hostile;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Opens every file of {@code src/test/resources/hostile} by the commands that read such files. None
 * may take long or much memory, end in an exception, print control characters or write where it was
 * not told to.
 *
 * <p>{@code -Dhostile.all=true} runs the scripts and reduces the models too, which takes minutes.
 */
class HostileFilesTest {
  private static final Path CORPUS = Path.of("src", "test", "resources", "hostile");
  private static final String PATH =
      Path.of("scenes", "paths", "desk-visit.csv").toAbsolutePath().toString();
  private static final String SCENE = Path.of("scenes", "hello.x3d").toAbsolutePath().toString();
  private static final boolean ALL = Boolean.getBoolean("hostile.all");

  /** The most that a command may take on a busy machine; most take less than a tenth of one. */
  private static final int SECONDS = 30;

  private static final Pattern CONTROL =
      Pattern.compile("[\\p{Cc}\\u202a-\\u202e\\u2066-\\u2069&&[^\\n\\r\\t]]");

  @TempDir Path folder;
  private CommandProcess process;
  private Path work;
  private final List<String> harm = new ArrayList<>();

  @BeforeEach
  void start() throws IOException {
    work = Files.createDirectories(folder.resolve("work"));
    process = new CommandProcess(work, SECONDS);
  }

  @AfterEach
  void end() {
    process.close();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "scenes",
        "endless",
        "scripts",
        "media",
        "models",
        "studies",
        "settings",
        "recordings"
      })
  void filesOfStrangersAreReadOrRefused(String kind) throws Exception {
    List<Path> files = copy(kind);
    for (Path file : files) {
      for (List<String> command : commands(kind, file)) {
        run(file, command);
      }
    }
    assertThat(harm).isEmpty();
    assertThat(names(folder)).as("beside the working folder").containsExactly("work");
    assertThat(files.stream().map(Path::getFileName).map(Path::toString))
        .as("the folder of the files")
        .containsExactlyInAnyOrderElementsOf(names(work.resolve(kind)));
    assertThat(names(work)).as("the working folder").isSubsetOf("home", "tmp", "out", kind);
  }

  /** A tracker is whoever listens at an address. */
  @Test
  void trackersMaySendAnything() throws Exception {
    for (Path file : copy("streams")) {
      byte[] bytes = Files.readAllBytes(file);
      String driver = file.getFileName().toString().startsWith("vrpn") ? "vrpn:T@" : "tcp:";
      try (ServerSocket server = new ServerSocket(0, 4, InetAddress.getLoopbackAddress())) {
        // Ends with the server.
        new Thread(() -> send(server, bytes), "hostile-tracker").start();
        run(
            file,
            List.of(
                "track",
                driver + "127.0.0.1:" + server.getLocalPort(),
                "--duration",
                "0.1",
                "--format",
                "csv"));
      }
    }
    assertThat(harm).isEmpty();
  }

  private static void send(ServerSocket server, byte[] bytes) {
    while (!server.isClosed()) {
      try (Socket client = server.accept();
          OutputStream to = client.getOutputStream()) {
        to.write(bytes);
      } catch (IOException e) {
        // The tracker was closed, or the server is.
      }
    }
  }

  /** These would be large as files. */
  @Test
  void scenesOfAnySizeAreReadOrRefused() throws Exception {
    TreeMap<String, String> scenes = new TreeMap<>();
    scenes.put("nested.x3d", x3d("<Group>".repeat(100_000) + "</Group>".repeat(100_000)));
    scenes.put("switch.x3d", x3d("<Switch>" + "<Group/>".repeat(50_000) + "</Switch>"));
    scenes.put(
        "uses.x3d",
        x3d("<Group DEF='G'/><Switch>" + "<Group USE='G'/>".repeat(50_000) + "</Switch>"));
    scenes.put("name.x3d", x3d("<Group DEF='" + "a".repeat(1_000_000) + "'/>"));
    scenes.put("element.x3d", x3d("<" + "a".repeat(1_000_000) + "/>"));
    scenes.put("arrays.x3dj", "{\"X3D\":" + "[".repeat(1_000_000));
    scenes.put(
        "braces.x3dv", "#X3D V4.0 utf8\nPROFILE Full\n" + "Group { children ".repeat(100_000));
    Path kind = Files.createDirectories(work.resolve("scenes"));
    for (String name : scenes.keySet()) {
      Path file = Files.writeString(kind.resolve(name), scenes.get(name));
      run(file, List.of("validate", file.toString()));
      run(file, List.of("simulate", "--rate", "2", "--path", PATH, file.toString()));
    }
    assertThat(harm).isEmpty();
  }

  private static String x3d(String nodes) {
    return "<X3D profile='Full' version='4.0'><Scene>" + nodes + "</Scene></X3D>";
  }

  private List<List<String>> commands(String kind, Path file) throws IOException {
    String name = file.toString();
    String ending = name.substring(name.lastIndexOf('.'));
    return switch (kind) {
      case "scenes" ->
          List.of(
              List.of("validate", name),
              List.of("simulate", "--rate", "2", "--path", PATH, name),
              List.of("polygons", name),
              List.of("convert", name, out(file, ".x3dv")));
      case "endless" -> // Each takes all the time that scripts may take.
          ALL
              ? List.of(
                  List.of("validate", name),
                  List.of("simulate", "--rate", "2", "--path", PATH, name))
              : List.of(List.of("validate", name));
      case "media" -> ofScene(file, medium(file));
      case "scripts" -> ofScene(file, script(file));
      case "models" ->
          ALL
              ? List.of(
                  List.of("validate", name),
                  List.of("simplify", "--vert-percent", "50", name, "--output", out(file, ".x3d")))
              : List.of(List.of("validate", name));
      case "studies" ->
          ending.equals(".json")
              ? List.of(
                  List.of("experiment", "status", name),
                  List.of(
                      "experiment",
                      "paper",
                      "--participant",
                      "1",
                      name,
                      "--output",
                      out(file, ".html")))
              : List.of();
      case "settings" ->
          ending.equals(".json")
              ? List.of(
                  List.of("validate", "--config", name, SCENE),
                  List.of("validate", "--baseline", name, SCENE))
              : List.of(
                  List.of("enrich", "--apply", name, "--dry-run", SCENE),
                  List.of("enrich", "--ratings", name, "--dry-run", SCENE));
      case "recordings" ->
          List.of(
              List.of("simulate", "--rate", "2", "--path", name, SCENE),
              List.of("track", "replay:" + name, "--duration", "0.01"),
              List.of("experiment", "view", name),
              List.of("experiment", "analyse", name));
      default -> throw new AssertionError(kind);
    };
  }

  private List<List<String>> ofScene(Path file, String nodes) throws IOException {
    Path out = Files.createDirectories(work.resolve("out"));
    Path scene = out.resolve(file.getFileName() + ".x3d");
    Files.writeString(scene, x3d(nodes));
    List<String> validate =
        List.of("validate", "--allow", file.getParent().toString(), scene.toString());
    boolean runs = ALL || !file.getParent().endsWith("scripts");
    List<String> simulate =
        List.of(
            "simulate",
            "--rate",
            "2",
            "--allow",
            file.getParent().toString(),
            "--path",
            PATH,
            scene.toString());
    return runs ? List.of(validate, simulate) : List.of(validate);
  }

  private static String medium(Path file) {
    String url = "url='\"../media/" + file.getFileName() + "\"'";
    return "<Shape><Appearance><ImageTexture %s/></Appearance><Box/></Shape>".formatted(url)
        + "<Shape><Appearance><MovieTexture %s loop='true'/></Appearance><Box/></Shape>"
            .formatted(url)
        + "<Shape><Appearance><ImageCubeMapTexture %s/></Appearance><Box/></Shape>".formatted(url)
        + "<Sound><MovieTexture containerField='source' %s loop='true'/></Sound>".formatted(url)
        + "<Sound><AudioClip containerField='source' %s loop='true'/></Sound>".formatted(url)
        + "<Background frontUrl='\"../media/%s\"'/>".formatted(file.getFileName());
  }

  private static String script(Path file) throws IOException {
    String program = Files.readString(file).replace("]]>", "]]]]><![CDATA[>");
    return "<Script><![CDATA[ecmascript:\n" + program + "]]></Script>";
  }

  private String out(Path file, String ending) throws IOException {
    Path out = Files.createDirectories(work.resolve("out"));
    return out.resolve(file.getFileName() + ending).toString();
  }

  private void run(Path file, List<String> command) throws InterruptedException {
    String what = String.join(" ", command).replace(work.toString(), "").replace(PATH, "PATH");
    try {
      CommandProcess.Result result = process.run(command);
      harm(what, result);
    } catch (IOException e) {
      harm.add(what + ": " + e.getMessage());
    }
    assertThat(file).as("after " + what).exists();
  }

  private void harm(String what, CommandProcess.Result result) {
    String said = result.out() + result.err();
    if (result.status() < 0 || result.status() > 2) {
      harm.add(what + ": exit status " + result.status());
    }
    for (String word : List.of("please report", "out of memory", "\tat ", "Exception")) {
      int at = said.indexOf(word);
      if (at >= 0) {
        harm.add(
            what + ": " + said.substring(Math.max(0, at - 40), Math.min(at + 300, said.length())));
      }
    }
    if (CONTROL.matcher(said).find()) {
      harm.add(what + ": prints control characters");
    }
  }

  private List<Path> copy(String kind) throws IOException {
    Path from = CORPUS.resolve(kind);
    if (!Files.isDirectory(from)) {
      return List.of();
    }
    Path to = Files.createDirectories(work.resolve(kind));
    List<Path> copies = new ArrayList<>();
    try (Stream<Path> files = Files.list(from)) {
      for (Path file : files.sorted().toList()) {
        copies.add(Files.copy(file, to.resolve(file.getFileName())));
      }
    }
    return copies;
  }

  private static Set<String> names(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return Set.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      Set<String> names = new TreeSet<>();
      files.forEach(file -> names.add(file.getFileName().toString()));
      return names;
    }
  }
}
