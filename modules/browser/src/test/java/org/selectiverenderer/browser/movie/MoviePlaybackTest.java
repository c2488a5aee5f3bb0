package org.selectiverenderer.browser.movie;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class MoviePlaybackTest {
  /** Ten pictures of one pixel, whose red is their number, a second each. */
  private static class Numbers implements Movie {
    final List<Integer> decoded = new CopyOnWriteArrayList<>();

    @Override
    public int width() {
      return 1;
    }

    @Override
    public int height() {
      return 1;
    }

    @Override
    public boolean translucent() {
      return false;
    }

    @Override
    public int pictures() {
      return 10;
    }

    @Override
    public double seconds() {
      return 10;
    }

    @Override
    public int at(double seconds) {
      return (int) Math.max(0, Math.min(9, seconds));
    }

    byte[] make(int picture) throws IOException {
      return new byte[] {(byte) picture, 0, 0, -1};
    }

    @Override
    public Pictures open() {
      return picture -> {
        decoded.add(picture);
        return make(picture);
      };
    }
  }

  @Test
  void whoeverWaitsSeesThePictureOfThatTime() {
    Numbers numbers = new Numbers();
    try (MovieDecoderPool room = new MovieDecoderPool()) {
      room.waitForPictures();
      MoviePlayback film = room.film(numbers, new byte[] {0, 0, 0, -1});

      film.stand(7.5, false);
      assertThat(film.picture().rgba()[0]).isEqualTo((byte) 7);
      film.stand(6.5, true);
      MoviePlayback.Picture six = film.picture();
      assertThat(six.rgba()[0]).isEqualTo((byte) 6);
      film.stand(6.1, true);
      assertThat(film.picture()).isSameAs(six);
    }
    assertThat(numbers.decoded).doesNotHaveDuplicates(); // A short film is kept.
  }

  @Test
  void nothingIsDecodedUnlessSomebodyLooks() {
    Numbers numbers = new Numbers();
    try (MovieDecoderPool room = new MovieDecoderPool()) {
      MoviePlayback film = room.film(numbers, new byte[] {0, 0, 0, -1});
      film.stand(3, false);
      film.stand(8, false);
    }
    assertThat(numbers.decoded).isEmpty();
  }

  @Test
  void untilItIsThereOneSeesWhatCameBefore() throws InterruptedException {
    CountDownLatch goOn = new CountDownLatch(1);
    Numbers slow =
        new Numbers() {
          @Override
          byte[] make(int picture) throws IOException {
            try {
              goOn.await(20, TimeUnit.SECONDS);
            } catch (InterruptedException e) {
              throw new IOException("was interrupted", e);
            }
            return super.make(picture);
          }
        };
    try (MovieDecoderPool room = new MovieDecoderPool()) {
      MoviePlayback film = room.film(slow, new byte[] {0, 0, 0, -1});
      film.stand(4, false);
      assertThat(film.picture().rgba()[0]).isZero();
      goOn.countDown();
      room.waitForPictures();
      assertThat(film.picture().rgba()[0]).as("the other eye").isZero();
      film.nextFrame();
      assertThat(film.picture().rgba()[0]).isEqualTo((byte) 4);
    }
  }

  @Test
  void damagedFilmIsToldOnceAndStays() {
    Numbers damaged =
        new Numbers() {
          @Override
          byte[] make(int picture) throws IOException {
            if (picture == 3) {
              throw new IOException("is damaged");
            }
            return super.make(picture);
          }
        };
    try (MovieDecoderPool room = new MovieDecoderPool()) {
      room.waitForPictures();
      MoviePlayback film = room.film(damaged, new byte[] {0, 0, 0, -1});
      film.stand(3, false);
      assertThat(film.picture().rgba()[0]).isZero();
      assertThat(film.fault()).contains("is damaged");
      assertThat(film.fault()).isEmpty();
      film.stand(5, false);
      assertThat(film.picture().rgba()[0]).isZero();
    }
    assertThat(damaged.decoded).containsExactly(3);
  }
}
