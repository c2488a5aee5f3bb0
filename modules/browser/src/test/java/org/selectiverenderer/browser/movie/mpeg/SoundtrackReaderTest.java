package org.selectiverenderer.browser.movie.mpeg;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class SoundtrackReaderTest {
  private static final int[] PACK = {0, 0, 1, 0xba, 0x21, 0, 1, 0, 1, 0x80, 0, 1};

  private final ByteArrayOutputStream file = new ByteArrayOutputStream();

  private SoundtrackReaderTest write(int... bytes) {
    for (int one : bytes) {
      file.write(one);
    }
    return this;
  }

  private Optional<byte[]> read(int limit) throws IOException {
    return SoundtrackReader.read(new ByteArrayInputStream(file.toByteArray()), limit);
  }

  @Test
  void thePacketsOfTheFirstSoundAreJoinedWithoutTheirHeaders() throws IOException {
    write(PACK).write(0, 0, 1, 0xe0, 0, 3, 0x0f, 0, 0); // a picture, then two sounds
    write(0, 0, 1, 0xc0, 0, 4, 0xff, 0x0f, 1, 2);
    write(0, 0, 1, 0xc1, 0, 2, 0x0f, 9);
    write(PACK).write(0, 0, 1, 0xc0, 0, 7, 0x21, 0, 0, 0, 0, 3, 4);
    assertThat(read(4).orElseThrow()).containsExactly(1, 2, 3, 4);
    assertThatThrownBy(() -> read(3)).hasMessageContaining("has a soundtrack of more than");
  }

  @Test
  void aFileThatIsCutOffHasWhatIsThere() throws IOException {
    write(PACK).write(0, 0, 1, 0xc0, 0xff, 0xff, 0x0f, 1, 2);
    assertThat(read(9).orElseThrow()).containsExactly(1, 2);
    write(0, 0, 1, 0xc0);
    assertThat(read(9)).isPresent();
  }

  @Test
  void otherFilesAndMoviesWithoutSoundHaveNone() throws IOException {
    assertThat(read(9)).isEmpty();
    write(0, 0, 1, 0xb3, 0, 0, 1, 0xc0, 0, 2, 0x0f, 1);
    assertThat(read(9)).isEmpty();
    file.reset();
    write(PACK).write(0, 0, 1, 0xe0, 0, 3, 0x0f, 0, 0);
    assertThat(read(9)).isEmpty();
  }
}
