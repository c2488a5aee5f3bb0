package org.selectiverenderer.lsl;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.lwjgl.system.APIUtil;
import org.lwjgl.system.SharedLibrary;
import org.selectiverenderer.base.natives.LwjglLibraries;

/** The liblsl that the user has installed. Once loaded, it stays loaded until the program ends. */
public final class LslLibrary {
  /** Name of the environment variable with the path of the library. */
  public static final String VARIABLE = "SELECTIVE_RENDERER_LSL";

  private static final String RELEASES = "https://github.com/sccn/liblsl/releases";

  private final LslBindings calls;

  private LslLibrary(LslBindings calls) {
    this.calls = calls;
  }

  /**
   * Loads the library: the named file, else the file that {@value #VARIABLE} names, else the
   * system's library by its usual names.
   *
   * @throws IOException if there is no such library, with a message that says what to do
   */
  public static LslLibrary open(Optional<Path> named) throws IOException {
    Optional<String> file =
        named
            .map(Path::toString)
            .or(() -> Optional.ofNullable(System.getenv(VARIABLE)).filter(text -> !text.isEmpty()));
    if (file.isPresent()) {
      if (!Files.isRegularFile(Path.of(file.get()))) {
        throw new IOException(
            file.get()
                + ": there is no such file; --lsl-library or "
                + VARIABLE
                + " must name the file of liblsl");
      }
      return load(
          List.of(Path.of(file.get()).toAbsolutePath().toString()),
          file.get()
              + ": cannot be loaded as liblsl, the library of the Lab Streaming Layer; take the one"
              + " for this machine from "
              + RELEASES);
    }
    return load(
        places(
            System.getProperty("os.name").toLowerCase(Locale.ROOT),
            Objects.requireNonNullElse(System.getenv("PATH"), "")),
        "liblsl, the library of the Lab Streaming Layer, is not installed or cannot be loaded;"
            + " install it from "
            + RELEASES
            + ", or name its file with --lsl-library or "
            + VARIABLE);
  }

  /**
   * Returns where the library is looked for, in this order. Windows and macOS look for a bare name
   * in the current directory too, which may hold files of others: there only whole paths are given.
   *
   * @param system name of the operating system in lower case
   * @param path the environment variable {@code PATH}, in which Windows finds libraries
   */
  static List<String> places(String system, String path) {
    if (system.startsWith("windows")) {
      return Stream.of(path.split(";"))
          .filter(folder -> folder.matches("[A-Za-z]:[\\\\/].*"))
          .flatMap(folder -> Stream.of("lsl.dll", "liblsl64.dll").map(name -> folder + "\\" + name))
          .toList();
    }
    return system.startsWith("mac")
        ? List.of("/opt/homebrew/lib/liblsl.dylib", "/usr/local/lib/liblsl.dylib")
        : List.of("liblsl.so", "liblsl.so.2", "/usr/local/lib/liblsl.so");
  }

  /**
   * @param missing message of the exception if none of them can be loaded
   */
  private static LslLibrary load(List<String> names, String missing) throws IOException {
    LwjglLibraries.use(LslLibrary.class); // Its libffi makes the calls.
    UnsatisfiedLinkError reason = new UnsatisfiedLinkError();
    for (String name : names) {
      try {
        SharedLibrary library = APIUtil.apiCreateLibrary(name);
        return new LslLibrary(new LslBindings(library));
      } catch (UnsatisfiedLinkError e) {
        reason.addSuppressed(e); // For --debug: LWJGL's message is about its own settings.
      }
    }
    throw new IOException(missing, reason);
  }

  /** Returns the version: 116 is 1.16. */
  public int version() {
    return calls.version.callInt();
  }

  /**
   * Returns the time of the library's clock on this machine, in seconds; it is monotonic and stamps
   * all samples.
   */
  public double clock() {
    return calls.clock.callDouble();
  }

  /**
   * Creates an outlet, which offers a stream to the network.
   *
   * @throws IOException if the library rejects the stream
   */
  public LslOutlet outlet(StreamInfo description) throws IOException {
    return LslOutlet.open(calls, description);
  }

  /**
   * Creates a resolver, which looks for streams in the background.
   *
   * @param predicate an XPath 1.0 predicate on a stream's description, such as {@code type='EEG'}
   * @throws IOException if the predicate is not valid
   */
  public LslResolver resolver(String predicate) throws IOException {
    return LslResolver.open(calls, predicate);
  }
}
