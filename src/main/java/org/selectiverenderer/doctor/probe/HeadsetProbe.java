package org.selectiverenderer.doctor.probe;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.base.files.HomeFolder;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.openxr.HeadsetUnavailableException;
import org.selectiverenderer.openxr.RuntimeManifest;
import org.selectiverenderer.openxr.XrHeadsetFinder;

/** Checks the OpenXR runtime and its headset. */
final class HeadsetProbe {
  private HeadsetProbe() {}

  static void run(Consumer<Diagnosis> found) {
    String manifest = manifest().map(HeadsetProbe::text).orElse("");
    try (XrHeadsetFinder search = XrHeadsetFinder.begin()) {
      found.accept(
          Diagnosis.ok(
              "OpenXR",
              "%s, headset %s%s%s"
                  .formatted(
                      search.runtime(),
                      search.headset(),
                      search.tracksEyes() ? ", tracks eyes" : "",
                      manifest)));
    } catch (HeadsetUnavailableException e) {
      found.accept(Diagnosis.missing("OpenXR", e.getMessage() + manifest, ""));
    }
  }

  static String text(Path manifest) {
    return Files.exists(manifest)
        ? "; set up by " + manifest
        : "; XR_RUNTIME_JSON names " + manifest + ", which does not exist";
  }

  /**
   * Returns the runtime manifest on Linux; on Windows it is in the registry, on macOS there is
   * none.
   */
  private static Optional<Path> manifest() {
    String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
    return system.startsWith("linux")
        ? RuntimeManifest.find(System.getenv(), HomeFolder.ofUser(), Path.of("/"))
        : Optional.empty();
  }
}
