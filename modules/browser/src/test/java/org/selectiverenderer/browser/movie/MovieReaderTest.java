package org.selectiverenderer.browser.movie;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;

class MovieReaderTest {
  private static final Path GIF =
      Path.of("modules/render/src/test/resources/conformance/texturing/_movies/parts.gif");

  private static Optional<Movie> read(byte[] bytes, long budget) throws IOException {
    UrlContent content = new UrlContent.OfBytes("key", "film", BaseUrl.folder(Path.of("")), bytes);
    return MovieReader.read(content, new AtomicLong(budget));
  }

  @Test
  void eachPictureOfGifHasItsTime() throws IOException {
    Movie movie = read(Files.readAllBytes(GIF), 1 << 20).orElseThrow();

    assertThat(movie.pictures()).isEqualTo(4);
    assertThat(movie.seconds()).isEqualTo(2.0);
    assertThat(movie.at(-1)).isZero();
    assertThat(movie.at(0.19)).isZero();
    assertThat(movie.at(0.2)).isEqualTo(1);
    assertThat(movie.at(0.75)).isEqualTo(2);
    assertThat(movie.at(5)).isEqualTo(3);
  }

  @Test
  void pictureOfGifIsTheSameInAnyOrder() throws IOException {
    Movie movie = read(Files.readAllBytes(GIF), 1 << 20).orElseThrow();
    Movie.Pictures onwards = movie.open();
    byte[][] pictures = new byte[4][];
    for (int i = 0; i < 4; i++) {
      pictures[i] = onwards.picture(i);
    }
    for (int i = 3; i >= 0; i--) {
      assertThat(onwards.picture(i)).isEqualTo(pictures[i]);
    }
  }

  @Test
  void timesThatNobodyCanMeanAreTenthsOfSeconds() throws IOException {
    byte[] gif = Files.readAllBytes(GIF);
    for (int i = 0; i + 5 < gif.length; i++) {
      if (gif[i] == 0x21 && gif[i + 1] == (byte) 0xf9 && gif[i + 2] == 4) {
        gif[i + 4] = 0;
      }
    }
    assertThat(read(gif, 1 << 20).orElseThrow().seconds()).isEqualTo(0.4);
  }

  @Test
  void aFilmThatIsCutOffSaysHowMuchOfItIsThere() throws IOException {
    byte[] film =
        Files.readAllBytes(
            Path.of(
                "modules/browser/src/test/resources/org/selectiverenderer/browser/movie/mandelbrot.m1v"));
    assertThat(read(film, 1 << 20).orElseThrow().flaw()).isEmpty();
    Movie cut = read(Arrays.copyOf(film, film.length - 10), 1 << 20).orElseThrow();
    assertThat(cut.flaw())
        .isEqualTo("is cut off or damaged at its end, after 13 pictures (0.52 s)");
    assertThat(read(Files.readAllBytes(GIF), 1 << 20).orElseThrow().flaw()).isEmpty();
  }

  @Test
  void damagedGifIsTold() throws IOException {
    byte[] gif = Files.readAllBytes(GIF);
    Random random = new Random(2);
    int told = 0;
    for (int round = 0; round < 200; round++) {
      byte[] damaged = Arrays.copyOf(gif, gif.length - random.nextInt(gif.length / 2));
      for (int i = 0; i < 4; i++) {
        damaged[10 + random.nextInt(damaged.length - 10)] = (byte) random.nextInt();
      }
      try {
        Optional<Movie> movie = read(damaged, 1 << 20);
        if (movie.isPresent()) {
          movie.get().open().picture(movie.get().pictures() - 1);
        }
      } catch (IOException e) {
        assertThat(e).hasMessageMatching("is a damaged GIF.*|has pictures of .*");
        told++;
      }
    }
    assertThat(told).isGreaterThan(0);
  }

  @Test
  void partOfGifIsNoLargerThanPicturesMayBe() throws IOException {
    byte[] gif = Files.readAllBytes(GIF);
    int at = gif.length - 1;
    while (gif[at] != 0x21 || gif[at + 1] != (byte) 0xf9) {
      at--; // The last part's time, then its extension, then its place and size.
    }
    while (gif[at] != 0x2c) {
      at++;
    }
    Arrays.fill(gif, at + 5, at + 9, (byte) 0xff);
    assertThatThrownBy(() -> read(gif, 1 << 20))
        .hasMessageStartingWith("has pictures of 65535 x 65535 pixels");
  }

  @Test
  void whatIsNoFilmIsLeftToOthers() throws IOException {
    assertThat(read(new byte[] {(byte) 0x89, 'P', 'N', 'G'}, 1 << 20)).isEmpty();
  }

  @Test
  void filmsTogetherHaveLimitedMemory() throws IOException {
    byte[] gif = Files.readAllBytes(GIF);
    assertThatThrownBy(() -> read(gif, 100))
        .hasMessage("has %s bytes, for which there is not enough memory".formatted(gif.length));
  }
}
