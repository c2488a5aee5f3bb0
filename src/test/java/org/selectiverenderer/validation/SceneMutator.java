package org.selectiverenderer.validation;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;

/** Good scenes, corrupted at random, always in the same way for the same seed. */
public final class SceneMutator {
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

  private final List<byte[]> seeds;
  private final Random random;

  /**
   * @throws IOException if the good scenes cannot be read
   */
  public SceneMutator(long seed) throws IOException {
    this.seeds = seeds();
    this.random = new Random(seed);
  }

  /** The next one. */
  public byte[] next() {
    return mutant(seeds.get(random.nextInt(seeds.size())), random);
  }

  private static List<byte[]> seeds() throws IOException {
    List<byte[]> seeds = new ArrayList<>();
    Path fixtures = Path.of("src/test/resources/org/selectiverenderer/validation/fixtures");
    try (Stream<Path> files = Files.list(fixtures)) {
      for (Path file : files.filter(SceneMutator::isGood).sorted().toList()) {
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
