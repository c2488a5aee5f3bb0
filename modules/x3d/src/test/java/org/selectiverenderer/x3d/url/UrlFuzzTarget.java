package org.selectiverenderer.x3d.url;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** Urls of scenes, resolved but not opened. */
public final class UrlFuzzTarget {
  private static final BaseUrl BASE = BaseUrl.folder(Path.of("").toAbsolutePath());
  private static final UrlResolver RESOLVER = new UrlResolver(Path.of("").toAbsolutePath());

  private UrlFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    for (String url : new String(input, StandardCharsets.UTF_8).split("\n")) {
      RESOLVER.resolve(url, BASE);
    }
  }
}
