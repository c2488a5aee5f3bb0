package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * A headset of an OpenXR runtime, with its frame loop and the handling of all its states: taken
 * off, covered by another program, lost, reconnected. A frame is {@link #next}, {@link #begin},
 * {@link #acquire} for both eyes, {@link #end}. None of them throws when the runtime is lost:
 * {@link #next} then returns no frames, tries to reconnect every second, and continues when the
 * runtime is back. Belongs to the thread that opened it.
 */
public final class XrHeadset implements AutoCloseable {
  private static final long RETRY = 1_000_000_000;

  private final XrLoader loader;
  private final GraphicsBinding binding;
  private final Posture posture;
  private final Consumer<HeadsetEvent> news;
  private final LongSupplier nanos;
  private @Nullable XrConnection connection;
  private @Nullable XrRunningSession sitting;
  private SessionState state = SessionState.UNKNOWN;
  private boolean running;
  private boolean there = true;
  private boolean recentred;
  private long retryAt;
  private HeadsetEvent.@Nullable Kind seen;
  private XrSession.@Nullable FrameTime time;
  private final FrameStatistics pacing = new FrameStatistics();
  private volatile XrHeadsetStatus status = XrHeadsetStatus.NONE;

  XrHeadset(
      XrLoader loader,
      XrConnection connection,
      GraphicsBinding binding,
      Posture posture,
      Consumer<HeadsetEvent> news,
      LongSupplier nanos) {
    this.loader = loader;
    this.connection = connection;
    this.binding = binding;
    this.posture = posture;
    this.news = news;
    this.nanos = nanos;
    try {
      sit(connection);
    } catch (XrResultException e) {
      lost(e.getMessage());
    }
  }

  private void sit(XrConnection on) {
    XrRunningSession begun = new XrRunningSession(on, binding, posture);
    sitting = begun;
    state = SessionState.UNKNOWN;
    running = false;
    there = true;
    recentred = true;
    seen = null;
    pacing.restart();
    tell(
        HeadsetEvent.Kind.FOUND,
        "headset %s, runtime %s, pictures of %dx%d for each eye, %s"
            .formatted(
                on.headset(),
                on.runtime(),
                begun.images().size().width(),
                begun.images().size().height(),
                begun.floor()
                    ? "heights above the real floor"
                    : posture == Posture.STANDING
                        ? "the floor is not known, so heights are those of the scene"
                        : "seated"));
    if (!on.position()) {
      tell(HeadsetEvent.Kind.FOUND, "the headset tracks its orientation only, not its position");
    }
  }

  /** Returns the size of an eye's picture; empty while the runtime is lost. */
  public Optional<RecommendedImageSize> size() {
    return Optional.ofNullable(sitting).map(known -> known.images().size());
  }

  /**
   * Returns the visibility masks, the left eye's first; the same list until they change.
   *
   * @return empty if the runtime has no masks
   */
  public List<VisibilityMask> hidden() {
    return sitting == null ? List.of() : sitting.hidden();
  }

  /** Returns the status of the headset; thread-safe. */
  public XrHeadsetStatus status() {
    return status;
  }

  /** Returns whether the origin of the space was reset since the last call. */
  public boolean takeRecentred() {
    boolean was = recentred;
    recentred = false;
    return was;
  }

  /** Returns whether the user sees the scene. */
  public boolean visible() {
    return running && there && (state == SessionState.VISIBLE || state == SessionState.FOCUSED);
  }

  /**
   * Waits until a frame is due.
   *
   * @return empty, without waiting, if no frame is due: the headset is not worn or lost
   */
  public Optional<XrFrame> next() {
    time = null;
    if (sitting == null) {
      again();
    }
    Optional<XrFrame> frame = guarded(this::due).flatMap(found -> found);
    status = status(frame);
    return frame;
  }

  private Optional<XrFrame> due() {
    XrRunningSession sat = sitting;
    XrConnection on = connection;
    if (sat == null || on == null) {
      return Optional.empty();
    }
    for (Optional<XrEvent> event = on.instance().poll();
        event.isPresent();
        event = on.instance().poll()) {
      heard(event.get(), sat);
      if (sitting != sat) {
        return Optional.empty();
      }
    }
    look();
    if (!running) {
      return Optional.empty();
    }
    XrSession.FrameTime due = sat.session().waitFrame();
    time = due;
    pacing.frame(due);
    Optional<XrFrame> frame = sat.frame(due);
    if (frame.isEmpty()) {
      // The runtime requires begin and end of every frame that was waited for.
      sat.session().beginFrame();
      sat.end(due.display(), false);
      time = null;
    }
    return frame;
  }

  private void heard(XrEvent event, XrRunningSession sat) {
    if (event instanceof XrEvent.State change) {
      state = change.state();
      switch (state) {
        case READY -> {
          sat.session().begin();
          running = true;
          pacing.restart();
        }
        case STOPPING -> {
          running = false;
          sat.session().end();
        }
        case LOSS_PENDING -> lost("the runtime ends the session");
        case EXITING -> {
          leave();
          tell(HeadsetEvent.Kind.LEAVE, "the headset's runtime asks the program to end");
        }
        default -> {
          // The state determines the visibility.
        }
      }
    } else if (event instanceof XrEvent.InstanceLoss) {
      lost("the runtime ends");
    } else if (event instanceof XrEvent.Recentred) {
      recentred = true;
      tell(HeadsetEvent.Kind.RECENTRED, "the origin of the room was reset in the headset");
    } else if (event instanceof XrEvent.Presence presence) {
      there = presence.there();
    } else if (event instanceof XrEvent.MaskChanged) {
      sat.readHidden();
    } else if (event instanceof XrEvent.ControllersChanged) {
      tell(HeadsetEvent.Kind.CONTROLLERS, sat.controllers());
    }
  }

  /** Reports when the user begins or ceases to see the scene. */
  private void look() {
    HeadsetEvent.Kind now =
        !visible()
            ? HeadsetEvent.Kind.AWAY
            : state == SessionState.FOCUSED ? HeadsetEvent.Kind.WORN : HeadsetEvent.Kind.COVERED;
    // The headset counts as taken off only after it was worn.
    boolean first = seen == null && now == HeadsetEvent.Kind.AWAY;
    if (now == seen || first) {
      return;
    }
    seen = now;
    tell(
        now,
        switch (now) {
          case WORN -> "the headset shows the scene";
          case COVERED -> "another program is in front of the scene in the headset";
          default -> "the headset was taken off, or shows another program";
        });
  }

  /** Begins the frame that was waited for. */
  public void begin() {
    guarded(
        () -> {
          if (sitting != null && time != null) {
            sitting.session().beginFrame();
          }
          return true;
        });
  }

  /**
   * Acquires the texture for an eye's picture, until the frame ends.
   *
   * @param eye 0 for the left one, 1 for the right one
   * @return the texture's OpenGL name; empty if the runtime was lost
   */
  public Optional<Integer> acquire(int eye) {
    XrRunningSession sat = sitting;
    return sat == null || time == null
        ? Optional.empty()
        : guarded(() -> sat.images().acquire(eye));
  }

  /**
   * Ends the frame and releases its textures.
   *
   * @param shown whether both eyes' pictures were drawn
   */
  public void end(boolean shown) {
    guarded(
        () -> {
          if (sitting != null && time != null) {
            sitting.end(time.display(), shown);
          }
          return true;
        });
    time = null;
  }

  /** Calls the runtime; after a failure the session is closed and the runtime counts as lost. */
  private <T> Optional<T> guarded(Supplier<T> call) {
    try {
      return Optional.of(call.get());
    } catch (XrResultException e) {
      lost(e.getMessage());
      return Optional.empty();
    }
  }

  private void lost(String why) {
    leave();
    tell(
        HeadsetEvent.Kind.LOST,
        "the headset's runtime was lost (%s); the program tries to reconnect every second"
            .formatted(why));
  }

  /** Closes session and connection; {@link #next} tries to reconnect after a second. */
  private void leave() {
    XrRunningSession sat = sitting;
    XrConnection on = connection;
    sitting = null;
    connection = null;
    running = false;
    time = null;
    seen = null;
    state = SessionState.UNKNOWN;
    retryAt = nanos.getAsLong() + RETRY;
    quietly(sat);
    quietly(on);
  }

  private static void quietly(@Nullable AutoCloseable left) {
    try {
      if (left != null) {
        left.close();
      }
    } catch (Exception e) {
      // A lost runtime has nothing left to close; its loss has been reported.
    }
  }

  private void again() {
    if (nanos.getAsLong() - retryAt < 0) {
      return;
    }
    retryAt = nanos.getAsLong() + RETRY;
    try {
      XrConnection found = XrConnection.open(loader);
      connection = found;
      sit(found);
    } catch (HeadsetUnavailableException e) {
      // The loss has been reported; the next attempt follows.
    } catch (XrResultException e) {
      leave();
    }
  }

  private void tell(HeadsetEvent.Kind kind, String text) {
    news.accept(new HeadsetEvent(kind, text));
  }

  private XrHeadsetStatus status(Optional<XrFrame> frame) {
    XrConnection on = connection;
    return new XrHeadsetStatus(
        on == null ? status.runtime() : on.runtime(),
        on == null ? status.headset() : on.headset(),
        visible(),
        sitting == null,
        pacing.rate(),
        pacing.frames(),
        pacing.missed(),
        frame.filter(due -> due.lead() >= 0).map(due -> due.lead() * 1e-6).orElse(status.leadMs()));
  }

  /**
   * Describes a status for people: {@code Monado 25.0.0, 90 Hz, 3 of 5400 frames missed, pose 21 ms
   * ahead}.
   */
  public static String describe(XrHeadsetStatus status) {
    if (status.lost()) {
      return "headset: the runtime %s was lost".formatted(status.runtime());
    }
    return String.format(
        Locale.ROOT,
        "headset: %s, %.0f Hz, %d of %d frames missed%s%s",
        status.runtime(),
        status.rate(),
        status.missed(),
        status.frames(),
        status.leadMs() > 0
            ? String.format(Locale.ROOT, ", pose %.0f ms ahead", status.leadMs())
            : "",
        status.visible() ? "" : ", not worn");
  }

  @Override
  public void close() {
    leave();
  }

  /** Counts the frames of a headset, and the display periods without a new frame. */
  private static final class FrameStatistics {
    private long last;
    private boolean going;
    private long frames;
    private long missed;
    private double rate;

    /** Restarts after a time without frames, which do not count as missed. */
    void restart() {
      going = false;
    }

    /** Counts a frame that is due. */
    void frame(XrSession.FrameTime time) {
      frames++;
      if (time.period() > 0) {
        rate = 1e9 / time.period();
        if (going && time.drawn()) {
          missed += Math.max(0, Math.round((time.display() - last) / (double) time.period()) - 1);
        }
      }
      going = time.drawn();
      last = time.display();
    }

    long frames() {
      return frames;
    }

    /** Returns the number of display periods in which the previous frame was shown again. */
    long missed() {
      return missed;
    }

    /** Returns the runtime's frame rate in frames per second; 0 before the first frame. */
    double rate() {
      return rate;
    }
  }
}
