package org.selectiverenderer.app.stream;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Assumptions;
import org.selectiverenderer.lsl.LslLibrary;

/**
 * Another program of the Lab Streaming Layer: Python with PyPI's {@code pylsl}, which carries a
 * liblsl of its own. Without it tests are skipped; where {@code SELECTIVE_RENDERER_REQUIRE_LSL} is
 * 1, as in CI, they fail.
 */
final class LslPeer implements AutoCloseable {
  private static final Path SCRIPT = Path.of("src/test/scripts/lsl-peer.py").toAbsolutePath();

  private final Process process;
  private final BufferedReader lines;

  private LslPeer(Process process) {
    this.process = process;
    lines =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
  }

  /** The liblsl of pylsl. */
  static LslLibrary library() throws IOException {
    Optional<Path> file = Optional.empty();
    try (LslPeer peer = start("library")) {
      String line = peer.next();
      file = Optional.ofNullable(line).map(Path::of).filter(Files::isRegularFile);
    } catch (IOException e) {
      require("python3 cannot be run: " + e.getMessage());
    }
    if (file.isEmpty()) {
      require("python3 has no pylsl with a liblsl");
    }
    return LslLibrary.open(file);
  }

  private static void require(String lack) {
    if ("1".equals(System.getenv("SELECTIVE_RENDERER_REQUIRE_LSL"))) {
      throw new IllegalStateException("SELECTIVE_RENDERER_REQUIRE_LSL=1, but " + lack);
    }
    Assumptions.abort(lack);
  }

  static LslPeer start(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of("python3", SCRIPT.toString()));
    command.addAll(List.of(arguments));
    return new LslPeer(
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start());
  }

  /** Its next line; null when it has ended. */
  @Nullable String next() throws IOException {
    return lines.readLine();
  }

  @Override
  public void close() {
    process.destroy();
  }
}
