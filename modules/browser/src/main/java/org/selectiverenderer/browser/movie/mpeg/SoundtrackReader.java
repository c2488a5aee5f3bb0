package org.selectiverenderer.browser.movie.mpeg;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/**
 * Extracts the first audio stream from an MPEG-1 system stream or an MPEG-2 program stream (ISO/IEC
 * 11172-1). Times in the stream are not used: picture and sound are taken to begin together.
 */
public final class SoundtrackReader {
  private static final int PACK = 0xba;
  private static final int FIRST_AUDIO = 0xc0;
  private static final int LAST_AUDIO = 0xdf;

  private SoundtrackReader() {}

  /**
   * Reads a file to its end; the caller closes it.
   *
   * @param limit the largest size of the audio stream in bytes
   * @return the MPEG audio; empty if the file is no such stream or has no sound
   * @throws IOException if the stream fails, or with a clause as message that follows the file's
   *     name if there is more sound
   */
  public static Optional<byte[]> read(InputStream in, int limit) throws IOException {
    int window = in.read() << 24 | in.read() << 16 | in.read() << 8 | in.read();
    if (window != (0x100 | PACK)) {
      return Optional.empty();
    }
    ByteArrayOutputStream audio = new ByteArrayOutputStream();
    int wanted = -1;
    for (int next = in.read(); next >= 0; next = in.read()) {
      window = window << 8 | next;
      if ((window & 0xffffff00) != 0x100 || next <= PACK) {
        continue; // A pack header contains no start code.
      }
      int length = Math.max(0, in.read()) << 8 | Math.max(0, in.read());
      byte[] packet = in.readNBytes(length);
      window = -1;
      if (next >= FIRST_AUDIO && next <= LAST_AUDIO && (wanted == -1 || next == wanted)) {
        wanted = next;
        int from = SystemStreamDemuxer.payload(packet, 0, packet.length);
        if (audio.size() + packet.length - from > limit) {
          throw new IOException("has a soundtrack of more than %s MB".formatted(limit >> 20));
        }
        audio.write(packet, from, packet.length - from);
      }
    }
    return audio.size() == 0 ? Optional.empty() : Optional.of(audio.toByteArray());
  }
}
