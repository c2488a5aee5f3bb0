package org.selectiverenderer.scriptengine.build;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.selectiverenderer.scriptengine.MeteredMethods;
import org.selectiverenderer.scriptengine.MeteredStatics;
import org.selectiverenderer.scriptengine.ScriptMeter;

/**
 * Writes the classes of Rhino's jar with the meter's calls in them:
 *
 * <pre>java RhinoTransformer RHINO.jar FOLDER STAMP</pre>
 *
 * <p>FOLDER holds this module's own classes already. STAMP is a file that tells what FOLDER was
 * made of, so that a build in which neither the jar nor these classes have changed does no work.
 *
 * <p>A call without arguments and result needs no new stack map frames, so what is inserted does
 * not depend on the code around it.
 */
public final class RhinoTransformer {
  private static final String MESSAGES = "org/mozilla/javascript/resources/Messages.properties";

  private RhinoTransformer() {}

  public static void main(String[] args) throws IOException {
    Path jar = Path.of(args[0]);
    Path folder = Path.of(args[1]);
    Path stamp = Path.of(args[2]);
    Map<String, byte[]> files = files(jar);
    String made = fingerprint(files, folder);
    if (isCurrent(stamp, made, folder, files.keySet())) {
      return;
    }
    Files.deleteIfExists(stamp);
    deleteAll(folder.resolve("org/mozilla")); // Another version may have other classes.
    for (Map.Entry<String, byte[]> file : metered(files).entrySet()) {
      Path path = folder.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      Files.write(path, file.getValue());
    }
    Files.writeString(stamp, made);
  }

  private static boolean isCurrent(Path stamp, String made, Path folder, Set<String> names)
      throws IOException {
    return Files.exists(stamp)
        && Files.readString(stamp).equals(made)
        && names.stream().allMatch(name -> Files.exists(folder.resolve(name)));
  }

  /** Returns a digest of all that the result depends on. */
  private static String fingerprint(Map<String, byte[]> files, Path folder) throws IOException {
    MessageDigest digest;
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
    files.forEach(
        (name, bytes) -> {
          digest.update(name.getBytes(StandardCharsets.UTF_8));
          digest.update(bytes);
        });
    for (Path own : all(folder.resolve(internal(ScriptMeter.class)).getParent())) {
      if (Files.isRegularFile(own)) {
        digest.update(Files.readAllBytes(own));
      }
    }
    String asm = String.valueOf(ClassWriter.class.getResource("ClassWriter.class"));
    digest.update(asm.getBytes(StandardCharsets.UTF_8)); // The jar's name tells its version.
    return HexFormat.of().formatHex(digest.digest());
  }

  private static List<Path> all(Path folder) throws IOException {
    if (!Files.exists(folder)) {
      return List.of();
    }
    try (Stream<Path> paths = Files.walk(folder)) {
      return paths.sorted().toList();
    }
  }

  private static void deleteAll(Path folder) throws IOException {
    for (Path path : all(folder).stream().sorted(Comparator.reverseOrder()).toList()) {
      Files.delete(path);
    }
  }

  /** Returns the files of a jar, by name, with the meter in their classes. */
  static Map<String, byte[]> metered(Map<String, byte[]> files) throws IOException {
    RecursionBreakers recursion = new RecursionBreakers();
    files.forEach(
        (name, bytes) -> {
          if (name.endsWith(".class")) {
            recursion.add(bytes);
          }
        });
    Set<String> entries = recursion.choose();
    Replacements replacements = Replacements.read();
    Map<String, byte[]> metered = new TreeMap<>();
    files.forEach(
        (name, bytes) ->
            metered.put(
                name,
                name.equals(MESSAGES)
                    ? withMessage(bytes)
                    : name.endsWith(".class") ? metered(bytes, replacements, entries) : bytes));
    return metered;
  }

  private static byte[] withMessage(byte[] messages) {
    return (new String(messages, StandardCharsets.UTF_8)
            + "\n%s=%s\n".formatted(MeteringVisitor.NO_BIG_INTEGERS, ScriptMeter.NO_BIG_INTEGERS))
        .getBytes(StandardCharsets.UTF_8);
  }

  private static Map<String, byte[]> files(Path jar) throws IOException {
    Map<String, byte[]> files = new TreeMap<>();
    try (ZipFile in = new ZipFile(jar.toFile())) {
      for (ZipEntry entry : (Iterable<ZipEntry>) in.stream().map(ZipEntry.class::cast)::iterator) {
        String name = entry.getName();
        if (!entry.isDirectory()
            && !name.equals("META-INF/MANIFEST.MF")
            && !name.equals("module-info.class")) {
          try (InputStream content = in.getInputStream(entry)) {
            files.put(name, content.readAllBytes());
          }
        }
      }
    }
    return files;
  }

  private static byte[] metered(byte[] original, Replacements replacements, Set<String> entries) {
    ClassReader reader = new ClassReader(original);
    ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    reader.accept(new MeteringVisitor(writer, replacements, entries), 0);
    return writer.toByteArray();
  }

  /** The methods that stand for those of the JDK, by owner, name and descriptor of the latter. */
  record Replacements(Map<String, String[]> instance, Map<String, String[]> statics) {
    private static final Map<String, String> OWNERS =
        Map.of(
            "equals", "java/util/Objects",
            "arraycopy", "java/lang/System",
            "valueOf", "java/lang/String",
            "parseDouble", "java/lang/Double",
            "normalize", "java/text/Normalizer");

    static Replacements read() throws IOException {
      Map<String, String[]> instance = new HashMap<>();
      read(
          MeteredMethods.class,
          (name, descriptor) -> {
            int end = descriptor.indexOf(';');
            String owner = descriptor.substring(2, end);
            instance.put(
                owner + "." + name + "(" + descriptor.substring(end + 1),
                new String[] {internal(MeteredMethods.class), name, descriptor});
          });
      Map<String, String[]> statics = new HashMap<>();
      read(
          MeteredStatics.class,
          (name, descriptor) ->
              statics.put(
                  OWNERS.getOrDefault(name, "java/util/Arrays") + "." + name + descriptor,
                  new String[] {internal(MeteredStatics.class), name, descriptor}));
      return new Replacements(instance, statics);
    }

    private interface Found {
      void method(String name, String descriptor);
    }

    private static void read(Class<?> type, Found found) throws IOException {
      try (InputStream in = type.getResourceAsStream(type.getSimpleName() + ".class")) {
        new ClassReader(in)
            .accept(
                new ClassVisitor(Opcodes.ASM9) {
                  @Override
                  public @Nullable MethodVisitor visitMethod(
                      int access,
                      String name,
                      String descriptor,
                      @Nullable String signature,
                      String @Nullable [] exceptions) {
                    if ((access & Opcodes.ACC_PUBLIC) != 0) {
                      found.method(name, descriptor);
                    }
                    return null;
                  }
                },
                ClassReader.SKIP_CODE);
      }
    }
  }

  static String internal(Class<?> type) {
    return type.getName().replace('.', '/');
  }
}
