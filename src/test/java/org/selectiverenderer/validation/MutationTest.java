package org.selectiverenderer.validation;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.validation.report.ReportFormat;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problem.Severity;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dReader;

/**
 * Good scenes, corrupted at random: whatever comes of it, the validator ends in bounded time with a
 * report and without an exception; and where the reader finds an error, so does the validator.
 */
class MutationTest {
  private static final int CASES = 10_000;
  private static final int PER_RUN = 100;
  private static final long SEED = 20261121;
  private static final Path BASE = Path.of("");
  private static final String[] WORDS = {
    "<",
    ">",
    "/>",
    "\"",
    "'",
    "&",
    "&#x0;",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "<?x?>",
    "NaN",
    "-1",
    "1e999",
    "99999999999",
    "DEF='A'",
    "USE='A'",
    "<Group>",
    "</Group>",
    "<Shape USE='A'/>",
    "<ProtoInstance name='P'/>",
    "<IS/>",
    "<ROUTE/>",
    "\u0000",
    "\u00e9",
    "\ud83d\ude00",
    "xmlns=''"
  };

  @Test
  void corruptedScenesAreAnsweredWithAReport() throws IOException {
    List<byte[]> seeds = seeds();
    Random random = new Random(SEED);
    for (int done = 0; done < CASES; done += PER_RUN) {
      List<SourceFile> files = new ArrayList<>();
      for (int i = 0; i < PER_RUN; i++) {
        String name = "case-" + (done + i) + ".x3d";
        byte[] seed = seeds.get(random.nextInt(seeds.size()));
        files.add(new SourceFile(BASE.resolve("scenes").resolve(name), name, mutant(seed, random)));
      }
      Assertions.assertTimeout(Duration.ofSeconds(60), () -> check(files));
    }
  }

  private static void check(List<SourceFile> files) throws IOException {
    Report report =
        new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), BASE)
            .validate(files);
    String text =
        ReportFormat.TEXT.write(report, new ReportFormat.Style(false, Severity.ERROR, "1"));
    assertThat(text).contains(" errors, ");
    Set<String> found =
        report.findings().stream()
            .map(finding -> finding.location().file())
            .collect(Collectors.toSet());
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    for (SourceFile file : files) {
      Problems problems = new Problems();
      byte[] content = Objects.requireNonNull(file.content());
      reader.read(file.name(), new ByteArrayInputStream(content), problems);
      boolean wrong =
          problems.list().stream().anyMatch(problem -> problem.severity() == Severity.ERROR);
      String scene = new String(content, UTF_8);
      if (wrong && !scene.contains("validate-ignore")) {
        assertThat(found).as("%s\n%s", problems.list(), scene).contains(file.name());
      }
    }
  }

  private static List<byte[]> seeds() throws IOException {
    List<byte[]> seeds = new ArrayList<>();
    Path fixtures = Path.of("src/test/resources/org/selectiverenderer/validation/fixtures");
    try (Stream<Path> files = Files.list(fixtures)) {
      for (Path file : files.filter(MutationTest::isGood).sorted().toList()) {
        seeds.add(Files.readAllBytes(file));
      }
    }
    seeds.add(Files.readAllBytes(Path.of("scenes/overlap.x3d")));
    seeds.add(Files.readAllBytes(Path.of("scenes/trashcan.x3d")));
    return seeds;
  }

  /** Valid and understood by the reader too: scripts that name what they stand in are not. */
  private static boolean isGood(Path file) {
    String name = file.getFileName().toString();
    return name.contains("-valid") && !name.equals("SR132-valid-script.x3d");
  }

  private static byte[] mutant(byte[] seed, Random random) {
    byte[] mutant = seed;
    for (int i = random.nextInt(4); i >= 0; i--) {
      mutant = mutated(mutant, random);
    }
    return mutant;
  }

  private static byte[] mutated(byte[] text, Random random) {
    int at = random.nextInt(text.length + 1);
    int length = Math.min(random.nextInt(30), text.length - at);
    return switch (random.nextInt(6)) {
      case 0 -> joined(text, at, at + length, new byte[0]); // left out
      case 1 -> joined(text, at, at, copy(text, at, at + length)); // twice
      case 2 -> joined(text, at, at, WORDS[random.nextInt(WORDS.length)].getBytes(UTF_8));
      case 3 ->
          joined(text, at, Math.min(text.length, at + 1), new byte[] {(byte) random.nextInt(256)});
      case 4 -> copy(text, 0, at); // cut off
      default -> { // a word of the text elsewhere
        int from = random.nextInt(text.length + 1);
        byte[] moved = copy(text, from, Math.min(text.length, from + length));
        yield joined(text, at, Math.min(text.length, at + moved.length), moved);
      }
    };
  }

  private static byte[] copy(byte[] text, int from, int to) {
    return java.util.Arrays.copyOfRange(text, from, to);
  }

  private static byte[] joined(byte[] text, int end, int start, byte[] between) {
    byte[] joined = new byte[end + between.length + text.length - start];
    System.arraycopy(text, 0, joined, 0, end);
    System.arraycopy(between, 0, joined, end, between.length);
    System.arraycopy(text, start, joined, end + between.length, text.length - start);
    return joined;
  }
}
