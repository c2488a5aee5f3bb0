package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.natives.NativePlatform;

class SerialLibraryTest {
  @ParameterizedTest
  @EnumSource
  void eachPlatformHasOne(NativePlatform platform) {
    ClassLoader loader = Objects.requireNonNull(SerialLibrary.class.getClassLoader());
    String resource = SerialLibrary.resource(platform);
    assertThat(loader.getResource(resource)).as(resource).isNotNull();
  }

  @Test
  void theFolderOfTemporaryFilesIsTheUsualOneAfterwards() {
    String before = System.getProperty("java.io.tmpdir");
    SerialLibrary.load();
    SerialLibrary.load();
    assertThat(System.getProperty("java.io.tmpdir")).isEqualTo(before);
  }
}
