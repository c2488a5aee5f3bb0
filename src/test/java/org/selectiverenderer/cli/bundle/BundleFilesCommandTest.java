package org.selectiverenderer.cli.bundle;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

/** What a package has beside the program, written once for all tests. */
class BundleFilesCommandTest {
  @TempDir private static Path folder;

  @BeforeAll
  static void write() {
    assertThat(new CommandTestCase().execute("bundle-files", folder.toString())).isZero();
  }

  @Test
  void everyCommandOfTheHelpHasAManualPage() throws IOException {
    try (Stream<Path> pages = Files.list(folder.resolve("man"))) {
      assertThat(pages.map(page -> page.getFileName().toString()))
          .contains(
              "selective-renderer.1",
              "selective-renderer-run.1",
              "selective-renderer-validate.1",
              "selective-renderer-experiment-run.1")
          .doesNotContain("selective-renderer-sai.1", "selective-renderer-bundle-files.1");
    }
  }

  @Test
  void aManualPageSaysWhatTheHelpSays() throws IOException {
    String page = Files.readString(folder.resolve("man/selective-renderer-validate.1"));
    assertThat(page)
        .startsWith(".TH \"selective\\-renderer\\-validate\" 1")
        .contains(".SH NAME\nselective\\-renderer\\-validate \\- ")
        .contains("\\fB\\-\\-format")
        .contains(".SH PARAMETERS\n")
        .contains(".SH EXIT STATUS\n")
        .contains("\n.BR selective\\-renderer (1)\n");
  }

  @Test
  void aReadersWindowBreaksTheLinesOfAManualPageBetweenWords() throws IOException {
    String page = Files.readString(folder.resolve("man/selective-renderer-run.1"));
    assertThat(page.indexOf("\n.ad l\n.nh\n")).isBetween(0, page.indexOf(".SH NAME"));
    assertThat(page).contains(" [\\-\\-swap=ANGLE[,ANGLE...]]... SCENE\n");
  }

  @Test
  void theExamplesOfAManualPageRunTheInstalledProgram() throws IOException {
    String page = Files.readString(folder.resolve("man/selective-renderer.1"));
    assertThat(page).contains("\n  selective\\-renderer run scenes/trashcan.x3d\n");
  }

  @Test
  void bothShellsCompleteCommandsAndOptions() throws IOException {
    String bash = Files.readString(folder.resolve("bash/selective-renderer"));
    String zsh = Files.readString(folder.resolve("zsh/_selective-renderer"));
    assertThat(bash).contains("validate").contains("--fail-on");
    assertThat(zsh).startsWith("#compdef selective-renderer\n").contains(bash);
  }

  @Test
  void theIconOfWindowsHoldsItsPictures() throws IOException {
    ByteBuffer ico = content("icons/selective-renderer.ico").order(ByteOrder.LITTLE_ENDIAN);
    List<Integer> sides = new ArrayList<>();
    for (int i = 0; i < ico.getShort(4); i++) {
      int entry = 6 + 16 * i;
      sides.add(side(ico, ico.getInt(entry + 12), ico.getInt(entry + 8)));
      assertThat(ico.get(entry)).isEqualTo((byte) (int) sides.get(i));
    }
    assertThat(sides).containsExactly(16, 24, 32, 48, 64, 256);
  }

  @Test
  void theIconOfMacOsHoldsItsPictures() throws IOException {
    ByteBuffer icns = content("icons/selective-renderer.icns");
    assertThat(icns.getInt(4)).isEqualTo(icns.capacity());
    List<String> found = new ArrayList<>();
    for (int at = 8; at < icns.capacity(); at += icns.getInt(at + 4)) {
      String type = new String(icns.array(), at, 4, StandardCharsets.US_ASCII);
      found.add(type + " " + side(icns, at + 8, icns.getInt(at + 4) - 8));
    }
    assertThat(found)
        .containsExactly("icp4 16", "icp5 32", "icp6 64", "ic07 128", "ic08 256", "ic09 512");
  }

  private static ByteBuffer content(String name) throws IOException {
    return ByteBuffer.wrap(Files.readAllBytes(folder.resolve(name)));
  }

  private static int side(ByteBuffer file, int offset, int length) throws IOException {
    var picture = ImageIO.read(new ByteArrayInputStream(file.array(), offset, length));
    assertThat(picture.getWidth()).isEqualTo(picture.getHeight());
    return picture.getWidth();
  }
}
