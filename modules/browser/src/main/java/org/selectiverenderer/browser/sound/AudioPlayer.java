package org.selectiverenderer.browser.sound;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Plays the voices of a scene on its own thread {@code sound}, which starts with the first voice.
 * {@link #play} and {@link #fault} are called by one thread; neither waits for the device.
 */
public final class AudioPlayer implements AutoCloseable {
  /** Number of audio frames that are mixed at a time. */
  static final int BLOCK = 1024;

  private final SoundLine.Opening device;
  private final VoiceMixer mixer = new VoiceMixer(SoundLine.RATE);
  private @Nullable Thread thread;

  // Guarded by this:
  private @Nullable List<Voice> latest;
  private @Nullable SoundLine line;
  private @Nullable String fault;
  private boolean closed;

  /**
   * @param device opens the device, with the first voice
   */
  public AudioPlayer(SoundLine.Opening device) {
    this.device = device;
  }

  /**
   * Plays these voices until the next call and stops those of the last call. Without another call
   * within half a second it falls silent.
   *
   * @param voices the voices of a frame
   */
  public void play(List<Voice> voices) {
    if (thread == null) {
      if (voices.isEmpty()) {
        return;
      }
      thread = new Thread(this::run, "sound");
      thread.start();
    }
    synchronized (this) {
      latest = voices;
      notifyAll();
    }
  }

  /** Returns why nothing is played, as a clause; reported once. */
  public synchronized Optional<String> fault() {
    Optional<String> told = Optional.ofNullable(fault);
    fault = null;
    return told;
  }

  private void run() {
    try {
      SoundLine opened = device.open();
      if (begin(opened)) {
        play(opened);
      }
      opened.close();
    } catch (IOException e) {
      synchronized (this) {
        fault = e.getMessage();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private synchronized boolean begin(SoundLine opened) {
    line = opened;
    return !closed;
  }

  private void play(SoundLine to) throws InterruptedException {
    double[] mixed = new double[2 * BLOCK];
    byte[] bytes = new byte[2 * mixed.length];
    while (awaitVoices()) {
      mixer.mix(mixed);
      for (int i = 0; i < mixed.length; i++) {
        int sample = (int) Math.round(Math.max(-1, Math.min(1, mixed[i])) * Short.MAX_VALUE);
        bytes[2 * i] = (byte) sample;
        bytes[2 * i + 1] = (byte) (sample >> 8);
      }
      if (!to.write(bytes, bytes.length)) {
        gone();
        return;
      }
    }
  }

  private synchronized void gone() {
    if (!closed) {
      fault = "the sound device has stopped accepting sound";
    }
  }

  /** Waits until there are voices to play; returns false if this was closed. */
  private synchronized boolean awaitVoices() throws InterruptedException {
    while (!closed) {
      if (latest != null) {
        mixer.voices(latest);
        latest = null;
      }
      if (!mixer.idle()) {
        return true;
      }
      wait();
    }
    return false;
  }

  /** Stops playing; the thread has ended when this returns. */
  @Override
  public void close() {
    SoundLine open;
    synchronized (this) {
      closed = true;
      open = line;
      notifyAll();
    }
    if (open != null) {
      open.close();
    }
    if (thread != null) {
      join(thread);
    }
  }

  private static void join(Thread ending) {
    try {
      ending.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
