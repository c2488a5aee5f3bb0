package org.selectiverenderer.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The options --allow and --allow-net, and the keys of the same in a settings file. */
class AllowedFilesTest extends CommandTestCase {
  private static final String BOX = "<Shape><Box/></Shape>";

  @TempDir private Path folder;

  @BeforeEach
  void parts() throws IOException {
    Files.createDirectories(folder.resolve("scenes"));
    Files.createDirectories(folder.resolve("parts"));
    Files.writeString(folder.resolve("parts/box.x3d"), scene(BOX));
    write("<Inline url='\"../parts/box.x3d\"'/>");
  }

  private static String scene(String nodes) {
    return "<X3D version='4.0' profile='Immersive'><Scene>" + nodes + "</Scene></X3D>";
  }

  private void write(String nodes) throws IOException {
    Files.writeString(folder.resolve("scenes/a.x3d"), scene(nodes));
  }

  private int polygons(String... more) {
    String[] args = new String[more.length + 2];
    args[0] = "polygons";
    args[1] = folder.resolve("scenes/a.x3d").toString();
    System.arraycopy(more, 0, args, 2, more.length);
    return execute(args);
  }

  @Test
  void aFolderThatIsAllowedIsRead() {
    assertThat(polygons()).isEqualTo(1);
    assertThat(messages()).contains("--allow " + folder.resolve("parts") + " would allow it");
    assertThat(polygons("--allow", folder.resolve("parts").toString())).isZero();
    assertThat(printed()).contains("12");
  }

  @Test
  void foldersAndHostsThatAreNoneAreWrongUsage() {
    assertThat(polygons("--allow", "nowhere")).isEqualTo(2);
    assertThat(messages()).contains("--allow nowhere: there is no such folder");
    assertThat(polygons("--allow-net", "https://example.org/")).isEqualTo(2);
    assertThat(messages()).contains("'https://example.org/' is no host");
  }

  @Test
  void aHostThatIsAllowedIsAsked() throws IOException {
    HttpServer server =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext(
        "/box.x3d",
        exchange -> {
          byte[] body = scene(BOX).getBytes(UTF_8);
          exchange.sendResponseHeaders(200, body.length);
          exchange.getResponseBody().write(body);
          exchange.close();
        });
    server.start();
    try {
      write(
          "<Inline url='\"none.x3d\" \"http://127.0.0.1:%d/box.x3d\"'/>"
              .formatted(server.getAddress().getPort()));
      assertThat(polygons()).isEqualTo(1);
      assertThat(polygons("--allow-net", "127.0.0.1")).isEqualTo(1); // ports 80 and 443
      assertThat(polygons("--allow-net", "127.0.0.1:" + server.getAddress().getPort())).isZero();
      assertThat(printed()).contains("12");
    } finally {
      server.stop(0);
    }
  }

  @Test
  void theValidatorsSettingsMayAllowThem() throws IOException {
    Path settings = folder.resolve("settings.json");
    Files.writeString(settings, "{\"allow\": [\"parts\"]}");
    String file = folder.resolve("scenes/a.x3d").toString();
    execute("validate", file);
    assertThat(printed()).contains("SR303");
    execute("validate", file, "--config", settings.toString());
    assertThat(printed()).doesNotContain("SR303");
    Files.writeString(settings, "{\"allow\": [\"nowhere\"], \"allowNet\": [\"a b\"]}");
    assertThat(execute("validate", file, "--config", settings.toString())).isEqualTo(2);
    assertThat(messages())
        .contains("there is no folder 'nowhere' relative to this file")
        .contains("'a b' is no host");
  }
}
