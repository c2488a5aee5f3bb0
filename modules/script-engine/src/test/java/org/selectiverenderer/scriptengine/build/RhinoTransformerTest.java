package org.selectiverenderer.scriptengine.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

class RhinoTransformerTest {
  private static final String LOOPS = "org/mozilla/javascript/Loops.class";
  private static final String NOTICE = "META-INF/NOTICE.txt";

  @TempDir Path folder;
  private Path jar;
  private Path classes;
  private Path stamp;

  /** What the transformer is to meter, in short. */
  static final class Loops {
    private Loops() {}

    static int loop(int rounds) {
      int sum = 0;
      for (int i = 0; i < rounds; i++) {
        sum += i;
      }
      return sum;
    }

    static int recursion(int depth) {
      return depth == 0 ? 0 : 1 + recursion(depth - 1);
    }

    static int straight(int one) {
      return one + 1;
    }

    static char[] array(int length) {
      return new char[length];
    }

    static int search(String text, String sought) {
      return text.indexOf(sought);
    }
  }

  @BeforeEach
  void writeJar() throws IOException {
    jar = folder.resolve("rhino.jar");
    classes = folder.resolve("classes");
    stamp = folder.resolve("stamp");
    try (InputStream loops = Loops.class.getResourceAsStream("RhinoTransformerTest$Loops.class")) {
      writeJar(Map.of(LOOPS, loops.readAllBytes(), NOTICE, bytes("Of Rhino")));
    }
  }

  private void writeJar(Map<String, byte[]> files) throws IOException {
    try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(jar))) {
      for (Map.Entry<String, byte[]> file : new TreeMap<>(files).entrySet()) {
        zip.putNextEntry(new ZipEntry(file.getKey()));
        zip.write(file.getValue());
      }
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private void transform() throws IOException {
    RhinoTransformer.main(new String[] {jar.toString(), classes.toString(), stamp.toString()});
  }

  @Test
  void loopsRecursionAndArraysAreMeteredAndSearchesReplaced() throws IOException {
    transform();

    Map<String, List<String>> calls = calls(Files.readAllBytes(classes.resolve(LOOPS)));
    assertThat(calls.get("loop")).containsExactly("ScriptMeter.tick");
    assertThat(calls.get("recursion")).containsExactlyInAnyOrder("ScriptMeter.tick", "recursion");
    assertThat(calls.get("straight")).isEmpty();
    assertThat(calls.get("array")).containsExactly("ScriptMeter.allocate");
    assertThat(calls.get("search")).containsExactly("MeteredMethods.indexOf");
    assertThat(classes.resolve(NOTICE)).hasContent("Of Rhino");
  }

  @Test
  void aSecondRunWithoutChangesWritesNothing() throws IOException {
    transform();
    Files.writeString(classes.resolve(NOTICE), "untouched");

    transform();

    assertThat(classes.resolve(NOTICE)).hasContent("untouched");
  }

  @Test
  void aFileThatIsMissingIsWrittenAgain() throws IOException {
    transform();
    Files.delete(classes.resolve(LOOPS));

    transform();

    assertThat(classes.resolve(LOOPS)).exists();
  }

  @Test
  void anotherVersionReplacesTheClassesOfTheOneBefore() throws IOException {
    writeJar(Map.of("org/mozilla/javascript/Old.txt", bytes("old")));
    transform();

    writeJar(Map.of("org/mozilla/javascript/New.txt", bytes("new")));
    transform();

    assertThat(classes.resolve("org/mozilla/javascript/New.txt")).hasContent("new");
    assertThat(classes.resolve("org/mozilla/javascript/Old.txt")).doesNotExist();
  }

  @Test
  void twoRunsGiveTheSameBytes() throws IOException {
    transform();
    byte[] first = Files.readAllBytes(classes.resolve(LOOPS));
    Files.delete(stamp);

    transform();

    assertThat(classes.resolve(LOOPS)).hasBinaryContent(first);
  }

  /** Returns the methods that each method of a class calls, without those of other packages. */
  private static Map<String, List<String>> calls(byte[] type) {
    Map<String, List<String>> calls = new TreeMap<>();
    new ClassReader(type)
        .accept(
            new ClassVisitor(Opcodes.ASM9) {
              @Override
              public MethodVisitor visitMethod(
                  int access, String name, String descriptor, String signature, String[] thrown) {
                List<String> called = calls.computeIfAbsent(name, key -> new ArrayList<>());
                return new MethodVisitor(Opcodes.ASM9) {
                  @Override
                  public void visitMethodInsn(
                      int opcode, String owner, String method, String type, boolean ofInterface) {
                    String simple = owner.substring(owner.lastIndexOf('/') + 1);
                    called.add(owner.contains("Loops") ? method : simple + "." + method);
                  }
                };
              }
            },
            0);
    return calls;
  }
}
