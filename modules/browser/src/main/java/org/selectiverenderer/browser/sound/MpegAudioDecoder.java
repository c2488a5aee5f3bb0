package org.selectiverenderer.browser.sound;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicLong;
import javazoom.jl.decoder.Bitstream;
import javazoom.jl.decoder.Decoder;
import javazoom.jl.decoder.Header;
import javazoom.jl.decoder.JavaLayerException;
import javazoom.jl.decoder.SampleBuffer;

/**
 * Decodes MPEG audio of layers I, II and III (MP3) by JLayer, which is given whole frames: their
 * number bounds memory and time. A frame that it cannot decode is silent, since a damaged sound
 * should not be lost altogether.
 */
final class MpegAudioDecoder {
  private final Bitstream in;
  private final short[] samples;
  private final int perFrame;
  private Decoder decoder = new Decoder();
  private int done;
  private boolean any;

  private MpegAudioDecoder(MpegFrames frames) {
    in = new Bitstream(new ByteArrayInputStream(frames.bytes()));
    perFrame = frames.samples() * frames.channels();
    samples = new short[perFrame * frames.count()];
  }

  /**
   * Decodes a stream.
   *
   * @param budget the bytes left for all recordings of a load; reduced by this one
   * @throws IOException with a clause as message that follows the file's name
   */
  static AudioBuffer decode(byte[] file, AtomicLong budget) throws IOException {
    MpegFrames frames = MpegFrames.of(file);
    long bytes = 2L * frames.samples() * frames.channels() * frames.count();
    SoundFileReader.spend(bytes, budget);
    // JLayer fills tables of its classes when it first needs them, without a lock of its own.
    synchronized (MpegAudioDecoder.class) {
      MpegAudioDecoder decoder = new MpegAudioDecoder(frames);
      decoder.decode();
      if (!decoder.any) {
        budget.addAndGet(bytes);
        throw new IOException("is damaged: none of its frames can be decoded");
      }
      return new AudioBuffer(decoder.samples, frames.channels(), frames.rate());
    }
  }

  private void decode() {
    for (; done < samples.length; done += perFrame) {
      try {
        Header header = in.readFrame();
        if (header == null) {
          return;
        }
        SampleBuffer frame = (SampleBuffer) decoder.decodeFrame(header, in);
        System.arraycopy(
            frame.getBuffer(), 0, samples, done, Math.min(perFrame, frame.getBufferLength()));
        any = true;
      } catch (JavaLayerException | RuntimeException e) { // It validates few numbers.
        decoder = new Decoder();
      } finally {
        in.closeFrame();
      }
    }
  }
}
