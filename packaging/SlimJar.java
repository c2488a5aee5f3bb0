import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;

/**
 * Copies the application's jar without the native parts of other platforms, and lays JOGL's beside
 * it, from where the program loads them while they have the bytes of those in the jar:
 *
 * <pre>java packaging/SlimJar.java target/selective-renderer.jar FOLDER PLATFORM SECONDS</pre>
 *
 * PLATFORM is one of those below, SECONDS the time of the files since 1970.
 */
public final class SlimJar {
  /** Where libraries keep native parts, each platform's below or in a name of its own. */
  private static final Pattern NATIVE =
      Pattern.compile(
          "natives/[^/]+/.*" // JOGL
              + "|(linux|windows|macos|freebsd)/[^/]+/org/lwjgl.*"
              + "|(Android|FreeBSD|Linux|OSX|OpenBSD|Solaris|Windows)/.*" // jSerialComm
              + "|com/formdev/flatlaf/natives/.+");

  private static final Map<String, List<String>> KEPT =
      Map.of(
          "linux-x64",
          List.of("natives/linux-amd64/", "linux/x64/", "Linux/x86_64/", "libflatlaf-linux-x86_64"),
          "linux-arm64",
          List.of(
              "natives/linux-aarch64/",
              "linux/arm64/",
              "Linux/armv8_64/",
              "libflatlaf-linux-arm64"),
          "windows-x64",
          List.of(
              "natives/windows-amd64/",
              "windows/x64/",
              "Windows/x86_64/",
              "flatlaf-windows-x86_64"),
          "macos-x64",
          List.of(
              "natives/macosx-universal/", "macos/x64/", "OSX/x86_64/", "libflatlaf-macos-x86_64"),
          "macos-arm64",
          List.of(
              "natives/macosx-universal/",
              "macos/arm64/",
              "OSX/aarch64/",
              "libflatlaf-macos-arm64"));

  private SlimJar() {}

  public static void main(String[] args) throws IOException {
    Path folder = Path.of(args[1]);
    List<String> kept = KEPT.get(args[2]);
    if (kept == null) {
      System.err.println("SlimJar: no such platform: " + args[2] + "; there are " + KEPT.keySet());
      System.exit(2);
      return;
    }
    FileTime time = FileTime.from(Long.parseLong(args[3]), java.util.concurrent.TimeUnit.SECONDS);
    Path jar = folder.resolve("selective-renderer.jar");
    Path natives = folder.resolve(kept.get(0));
    Files.createDirectories(natives);
    try (ZipFile in = new ZipFile(args[0]);
        OutputStream file = Files.newOutputStream(jar);
        ZipOutputStream out = new ZipOutputStream(file)) {
      for (ZipEntry entry : (Iterable<ZipEntry>) in.stream().map(ZipEntry.class::cast)::iterator) {
        String name = entry.getName();
        // Folders stay: where JOGL has to unpack its libraries, it finds them by their folder, or
        // else
        // by each of its parts in turn, and then overwrites libraries that are loaded.
        if (NATIVE.matcher(name).matches() && kept.stream().noneMatch(name::contains)) {
          continue;
        }
        byte[] content;
        try (InputStream stream = in.getInputStream(entry)) {
          content = stream.readAllBytes();
        }
        ZipEntry copy = new ZipEntry(name);
        copy.setTimeLocal(entry.getTimeLocal());
        out.putNextEntry(copy);
        out.write(content);
        out.closeEntry();
        if (!entry.isDirectory() && name.startsWith(kept.get(0))) {
          Files.write(natives.resolve(name.substring(kept.get(0).length())), content);
        }
      }
    }
    Files.setLastModifiedTime(jar, time);
  }
}
