package org.selectiverenderer.lsl;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LslLibraryTest {
  /** Windows and macOS would look for a bare name in it, which may be a folder of others. */
  @Test
  void theCurrentDirectoryIsNoPlaceForTheLibrary() {
    assertThat(LslLibrary.places("windows 11", "C:\\lsl;.;;bin;D:/tools;\\\\host\\share"))
        .containsExactly(
            "C:\\lsl\\lsl.dll",
            "C:\\lsl\\liblsl64.dll",
            "D:/tools\\lsl.dll",
            "D:/tools\\liblsl64.dll");
    assertThat(LslLibrary.places("windows 11", "")).isEmpty();
    assertThat(LslLibrary.places("mac os x", "/bin")).allMatch(place -> place.startsWith("/"));
    // The loader of Linux looks for bare names in the folders of the system only.
    assertThat(LslLibrary.places("linux", "/bin"))
        .allMatch(place -> place.startsWith("/") || !place.contains("/"));
  }
}
