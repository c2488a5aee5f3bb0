package org.selectiverenderer.render.context;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.base.natives.NativeLibraryFolder;
import org.selectiverenderer.base.natives.NativePlatform;

/**
 * Makes JOGL load its native libraries from a folder of the user's own. JOGL itself unpacks them at
 * every start into the folder of temporary files, and runs a script there to find out whether
 * programs may run in it; that takes a fifth of a second of processor time, and can be the work of
 * another user.
 */
public final class JoglNativeLibraries {
  private static final String UNPACKS_ITSELF = "jogamp.gluegen.UseTempJarCache";

  private static final List<String> EVERYWHERE =
      List.of("gluegen_rt", "jogl_desktop", "jogl_mobile", "nativewindow_awt", "newt_head");

  private JoglNativeLibraries() {}

  /**
   * Makes JOGL load its libraries from the folder. To be called before the first use of JOGL, whose
   * initial settings stay; a second call does nothing. On a machine for which the program brings no
   * libraries, the system's own are loaded.
   *
   * @throws java.io.UncheckedIOException with one line, if there is no folder that is safe from
   *     others
   */
  public static synchronized void use() {
    if (System.getProperty(UNPACKS_ITSELF) != null) {
      return; // Called before, or the user has decided.
    }
    NativePlatform.current()
        .filter(platform -> platform != NativePlatform.WINDOWS_ARM64)
        .ifPresent(JoglNativeLibraries::use);
    System.setProperty(UNPACKS_ITSELF, "false");
  }

  private static void use(NativePlatform platform) {
    Path folder =
        NativeLibraryFolder.ofUser()
            .packaged(JoglNativeLibraries.class, "jogl", resources(platform));
    String before = System.getProperty("java.library.path", "");
    System.setProperty("java.library.path", folder + System.getProperty("path.separator") + before);
    // JOGL looks for what the system lacks, such as libGL, in the current directory, where it reads
    // this property: it may be that of somebody's scene. Java itself does not ask it for file
    // names.
    System.setProperty("user.dir", folder.toString());
  }

  /** Returns the resources that are JOGL's libraries for a platform. */
  static List<String> resources(NativePlatform platform) {
    List<String> own =
        platform.windows()
            ? List.of("nativewindow_win32")
            : platform.mac()
                ? List.of("nativewindow_macosx")
                : List.of("nativewindow_x11", "nativewindow_drm", "newt_drm");
    return Stream.concat(EVERYWHERE.stream(), own.stream())
        .map(library -> "natives/%s/%s".formatted(folder(platform), platform.file(library)))
        .toList();
  }

  private static String folder(NativePlatform platform) {
    if (platform.mac()) {
      return "macosx-universal";
    }
    if (platform.windows()) {
      return "windows-amd64";
    }
    return platform.arm() ? "linux-aarch64" : "linux-amd64";
  }
}
