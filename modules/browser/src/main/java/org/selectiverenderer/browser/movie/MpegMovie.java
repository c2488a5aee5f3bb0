package org.selectiverenderer.browser.movie;

import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.browser.movie.mpeg.MpegVideo;

/** A movie of MPEG-1 video, in which all frames have the same duration. */
record MpegMovie(MpegVideo video) implements Movie {
  @Override
  public int width() {
    return video.width();
  }

  @Override
  public int height() {
    return video.height();
  }

  @Override
  public boolean translucent() {
    return false;
  }

  @Override
  public int pictures() {
    return video.pictures();
  }

  @Override
  public double seconds() {
    return pictures() / video.rate();
  }

  @Override
  public int at(double seconds) {
    return (int) Math.max(0, Math.min(pictures() - 1.0, Math.floor(seconds * video.rate())));
  }

  @Override
  public String flaw() {
    return video.cutOff()
        ? "is cut off or damaged at its end, after %s pictures (%s s)"
            .formatted(pictures(), DecimalFormatter.rounded(seconds(), 2))
        : "";
  }

  @Override
  public Pictures open() {
    return video.decoder()::picture;
  }
}
