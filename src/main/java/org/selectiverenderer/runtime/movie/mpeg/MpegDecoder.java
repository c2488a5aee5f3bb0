package org.selectiverenderer.runtime.movie.mpeg;

import org.jspecify.annotations.Nullable;

/**
 * Makes the pictures of a film. One after the other is fast; for one elsewhere all are decoded that
 * it comes from. What is damaged looks damaged. Belongs to one thread at a time.
 */
public final class MpegDecoder {
  private final MpegVideo video;
  private final MpegCodes codes = MpegCodes.load();
  private final SampleBlock block = new SampleBlock(codes.coefficient());
  private final int across;
  private final int down;

  /** The last two pictures that others come from, the older one first. */
  private @Nullable Planes before;

  private @Nullable Planes after;
  private @Nullable Planes between;
  private int beforeIs = -1;
  private int afterIs = -1;
  private int betweenIs = -1;

  /** The next one to be decoded, in the order of coding. */
  private int next;

  MpegDecoder(MpegVideo video) {
    this.video = video;
    across = (video.width() + 15) / 16;
    down = (video.height() + 15) / 16;
  }

  /**
   * Makes a picture.
   *
   * @param picture 0 to {@link MpegVideo#pictures()} without it
   * @return four bytes r, g, b, a per pixel; the first row is the lowest
   */
  public byte[] picture(int picture) {
    int code = video.coded(picture);
    if (made(code) == null) {
      int key = video.keyOf(code);
      if (next > code || next < key) {
        next = key;
        beforeIs = -1;
        afterIs = -1;
      }
      for (; next <= code; next++) {
        if (video.type(next) != MpegVideo.BETWEEN || next == code) {
          decode(next);
        }
      }
    }
    Planes made = made(code);
    return (made == null ? new Planes(across, down) : made).rgba(video.width(), video.height());
  }

  private @Nullable Planes made(int code) {
    return code == beforeIs ? before : code == afterIs ? after : code == betweenIs ? between : null;
  }

  private void decode(int code) {
    Planes target;
    Planes forward;
    if (video.type(code) == MpegVideo.BETWEEN) {
      target = between == null ? new Planes(across, down) : between;
      between = target;
      betweenIs = code;
      forward = before;
    } else {
      target = before == null ? new Planes(across, down) : before;
      before = after;
      beforeIs = afterIs;
      after = target;
      afterIs = code;
      forward = before;
    }
    // Without one before it, as in damaged films, what is not coded stays as it was.
    Planes from = forward == null ? target : forward;
    Planes to = after == null ? from : after;
    slices(code, target, from, to);
  }

  /** Whether a picture, by the order of coding, is there to its end. */
  boolean complete(int code) {
    Planes any = new Planes(across, down);
    return slices(code, any, any, any);
  }

  /** Makes a picture's slices; whether the last of them is whole. */
  private boolean slices(int code, Planes target, Planes forward, Planes backward) {
    int start = video.start(code);
    int end = video.end(code);
    BitReader header = new BitReader(video.data, start + 4, end);
    header.skip(10 + 3 + 16);
    int type = video.type(code);
    Slice.Vectors ahead = type == MpegVideo.WHOLE ? Slice.Vectors.NONE : vectors(header);
    Slice.Vectors back = type == MpegVideo.BETWEEN ? vectors(header) : Slice.Vectors.NONE;
    Slice slice =
        new Slice(
            codes,
            block,
            new Slice.Weights(video.intraWeights, video.weights),
            type,
            new Slice.Pictures(target, forward, backward, across, down),
            ahead,
            back);
    int at = MpegVideo.next(video.data, start + 4);
    while (at < end) {
      int which = SystemStream.startCode(video.data, at);
      int behind = Math.min(end, MpegVideo.next(video.data, at + 4));
      if (which > MpegVideo.PICTURE && which <= MpegVideo.LAST_SLICE) {
        slice.read(new BitReader(video.data, at + 4, behind), which - 1);
      }
      at = behind;
    }
    return slice.complete();
  }

  private static Slice.Vectors vectors(BitReader header) {
    boolean wholePixels = header.bit();
    return new Slice.Vectors(wholePixels, Math.max(0, header.read(3) - 1));
  }
}
