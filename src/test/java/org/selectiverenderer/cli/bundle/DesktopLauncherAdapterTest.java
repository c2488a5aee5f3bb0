package org.selectiverenderer.cli.bundle;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class DesktopLauncherAdapterTest {
  private static final Map<String, String> ENTRY = Map.of("SELECTIVE_RENDERER_DESKTOP", "1");

  private static PrintStream messages(DesktopLauncherAdapter start, OutputStream err) {
    return new PrintStream(start.messages(err), true, StandardCharsets.UTF_8);
  }

  @Test
  void aFileThatADesktopOpensIsGivenToItsCommand() {
    assertThat(new DesktopLauncherAdapter("run", Map.of(), false).arguments(new String[] {"a.x3d"}))
        .containsExactly("run", "a.x3d");
  }

  @Test
  void withoutAFileTheViewerIsTheStartWindowAndTheEnricherOpensEmpty() {
    assertThat(new DesktopLauncherAdapter("run", Map.of(), false).arguments(new String[] {}))
        .containsExactly("start");
    assertThat(new DesktopLauncherAdapter("enrich", Map.of(), false).arguments(new String[] {}))
        .containsExactly("enrich");
    assertThat(new DesktopLauncherAdapter(null, ENTRY, false).arguments(new String[] {"run"}))
        .containsExactly("start");
  }

  @Test
  void aDoubleClickOpensTheStartWindowAndATerminalGetsTheUsage() {
    assertThat(new DesktopLauncherAdapter(null, Map.of(), true).arguments(new String[] {}))
        .containsExactly("start");
    assertThat(new DesktopLauncherAdapter(null, Map.of(), false).arguments(new String[] {}))
        .isEmpty();
    assertThat(new DesktopLauncherAdapter(null, Map.of(), false).arguments(new String[] {"run"}))
        .containsExactly("run");
  }

  @Test
  void anEntryOfADesktopNamesTheCommandItself() {
    assertThat(
            new DesktopLauncherAdapter(null, ENTRY, false).arguments(new String[] {"run", "a.x3d"}))
        .containsExactly("run", "a.x3d");
  }

  @Test
  void whatAFailureSaysIsToldAndStillWritten() {
    DesktopLauncherAdapter start = new DesktopLauncherAdapter(null, ENTRY, false);
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    messages(start, err).print("a.x3d: no such file\n");
    assertThat(err.toString(StandardCharsets.UTF_8)).isEqualTo("a.x3d: no such file\n");
    assertThat(start.complaint(2)).contains("a.x3d: no such file");
  }

  @Test
  void whereThereIsNoConsoleItIsToldToo() {
    DesktopLauncherAdapter start = new DesktopLauncherAdapter("run", Map.of(), false);
    OutputStream none =
        new OutputStream() {
          @Override
          public void write(int one) throws IOException {
            throw new IOException("The handle is invalid");
          }
        };
    PrintStream messages = messages(start, none);
    messages.print("first\n");
    messages.print("second\n");
    assertThat(start.complaint(1)).contains("first\nsecond");
  }

  @Test
  void remarksOfARunThatEndsWellAreNotTold() {
    DesktopLauncherAdapter start = new DesktopLauncherAdapter("run", Map.of(), false);
    messages(start, OutputStream.nullOutputStream()).println("a remark");
    assertThat(start.complaint(0)).isEmpty();
  }

  @Test
  void inATerminalNothingIsToldTwice() {
    DesktopLauncherAdapter start = new DesktopLauncherAdapter(null, Map.of(), false);
    messages(start, OutputStream.nullOutputStream()).println("seen");
    assertThat(start.complaint(2)).isEmpty();
  }

  @Test
  void ofManyLinesTheLastAreTold() {
    DesktopLauncherAdapter start = new DesktopLauncherAdapter("run", Map.of(), false);
    PrintStream messages = messages(start, OutputStream.nullOutputStream());
    IntStream.range(0, 5000).forEach(i -> messages.print("remark " + i + "\n"));
    messages.print("the failure\n");
    String told = start.complaint(1).orElseThrow();
    assertThat(told).endsWith("remark 4999\nthe failure").hasSizeLessThan(4100);
    assertThat(told.lines().limit(1)).allMatch(line -> line.matches("remark \\d{4}"));
  }
}
