package org.selectiverenderer.openxr;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * A headset behind a runtime, through everything that may become of either: taken off, covered,
 * gone, there again. A frame is {@link #next}, {@link #begin}, {@link #acquire} for both eyes,
 * {@link #end}; none of them fails when the runtime goes away: then {@link #next} has no frames,
 * looks for it every second, and goes on when it is back. Belongs to the thread that opened it.
 */
public final class XrHeadset implements AutoCloseable {
  private static final long RETRY = 1_000_000_000;

  private final XrLoader loader;
  private final GraphicsBinding binding;
  private final Posture posture;
  private final Consumer<HeadsetNews> news;
  private final LongSupplier nanos;
  private @Nullable XrConnection connection;
  private @Nullable XrSitting sitting;
  private SessionState state = SessionState.UNKNOWN;
  private boolean running;
  private boolean there = true;
  private boolean recentred;
  private long retryAt;
  private HeadsetNews.@Nullable Kind seen;
  private XrSession.@Nullable FrameTime time;
  private final FramePacing pacing = new FramePacing();
  private volatile XrStatus status = XrStatus.NONE;

  XrHeadset(
      XrLoader loader,
      XrConnection connection,
      GraphicsBinding binding,
      Posture posture,
      Consumer<HeadsetNews> news,
      LongSupplier nanos) {
    this.loader = loader;
    this.connection = connection;
    this.binding = binding;
    this.posture = posture;
    this.news = news;
    this.nanos = nanos;
    try {
      sit(connection);
    } catch (XrFailure e) {
      lost(e.getMessage());
    }
  }

  private void sit(XrConnection on) {
    XrSitting begun = new XrSitting(on, binding, posture);
    sitting = begun;
    state = SessionState.UNKNOWN;
    running = false;
    there = true;
    recentred = true;
    seen = null;
    pacing.restart();
    tell(
        HeadsetNews.Kind.FOUND,
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
      tell(HeadsetNews.Kind.FOUND, "the headset tells only how it is turned, not where it is");
    }
  }

  /** The size of an eye's picture; empty while the runtime is gone. */
  public Optional<PictureSize> size() {
    return Optional.ofNullable(sitting).map(known -> known.images().size());
  }

  /**
   * What the lens of each eye hides, the left one's first; the same list until that changes.
   *
   * @return empty when nobody knows
   */
  public List<HiddenArea> hidden() {
    return sitting == null ? List.of() : sitting.hidden();
  }

  /** How it does; any thread. */
  public XrStatus status() {
    return status;
  }

  /** Whether the middle of the room was set anew since the last call. */
  public boolean takeRecentred() {
    boolean was = recentred;
    recentred = false;
    return was;
  }

  /** Whether the user sees the scene. */
  public boolean visible() {
    return running && there && (state == SessionState.VISIBLE || state == SessionState.FOCUSED);
  }

  /**
   * Waits until a frame is due.
   *
   * @return empty at once when none is: nobody sees the headset, or there is none
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
    XrSitting sat = sitting;
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
      // The runtime counts on every frame that was waited for.
      sat.session().beginFrame();
      sat.end(due.display(), false);
      time = null;
    }
    return frame;
  }

  private void heard(XrEvent event, XrSitting sat) {
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
          tell(HeadsetNews.Kind.LEAVE, "the headset's runtime asks the program to end");
        }
        default -> {
          // What is seen follows from the state.
        }
      }
    } else if (event instanceof XrEvent.InstanceLoss) {
      lost("the runtime ends");
    } else if (event instanceof XrEvent.Recentred) {
      recentred = true;
      tell(HeadsetNews.Kind.RECENTRED, "the middle of the room was set anew");
    } else if (event instanceof XrEvent.Presence presence) {
      there = presence.there();
    } else if (event instanceof XrEvent.MaskChanged) {
      sat.readHidden();
    } else if (event instanceof XrEvent.ControllersChanged) {
      tell(HeadsetNews.Kind.CONTROLLERS, sat.controllers());
    }
  }

  /** Tells when the user begins or ceases to see the scene. */
  private void look() {
    HeadsetNews.Kind now =
        !visible()
            ? HeadsetNews.Kind.AWAY
            : state == SessionState.FOCUSED ? HeadsetNews.Kind.WORN : HeadsetNews.Kind.COVERED;
    // Before it was seen for the first time it has not gone.
    boolean first = seen == null && now == HeadsetNews.Kind.AWAY;
    if (now == seen || first) {
      return;
    }
    seen = now;
    tell(
        now,
        switch (now) {
          case WORN -> "the headset shows the scene";
          case COVERED -> "another program is in front of the scene in the headset";
          default -> "nobody sees the headset: it was taken off, or shows something else";
        });
  }

  /** The frame that was waited for begins. */
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
   * The texture that an eye's picture is to be drawn into, until the frame ends.
   *
   * @param eye 0 for the left one, 1 for the right one
   * @return its OpenGL name; empty when the runtime has gone
   */
  public Optional<Integer> acquire(int eye) {
    XrSitting sat = sitting;
    return sat == null || time == null
        ? Optional.empty()
        : guarded(() -> sat.images().acquire(eye));
  }

  /**
   * The frame ends; what was acquired is given back.
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

  /** Calls the runtime; when it fails, the session is given up and looked for again. */
  private <T> Optional<T> guarded(Supplier<T> call) {
    try {
      return Optional.of(call.get());
    } catch (XrFailure e) {
      lost(e.getMessage());
      return Optional.empty();
    }
  }

  private void lost(String why) {
    leave();
    tell(
        HeadsetNews.Kind.LOST,
        "the headset's runtime has gone (%s); it is looked for every second".formatted(why));
  }

  /** Gives everything up; {@link #next} looks for it again in a second. */
  private void leave() {
    XrSitting sat = sitting;
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
      // Of a runtime that has gone nothing is left to let go of; that it has is told.
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
      // Told when it was lost; it is tried again.
    } catch (XrFailure e) {
      leave();
    }
  }

  private void tell(HeadsetNews.Kind kind, String text) {
    news.accept(new HeadsetNews(kind, text));
  }

  private XrStatus status(Optional<XrFrame> frame) {
    XrConnection on = connection;
    return new XrStatus(
        on == null ? status.runtime() : on.runtime(),
        on == null ? status.headset() : on.headset(),
        visible(),
        sitting == null,
        pacing.rate(),
        pacing.frames(),
        pacing.missed(),
        frame.filter(due -> due.lead() >= 0).map(due -> due.lead() * 1e-6).orElse(status.leadMs()));
  }

  /** For people: {@code Monado 25.0.0, 90 Hz, 3 of 5400 frames missed, pose 21 ms ahead}. */
  public static String describe(XrStatus status) {
    if (status.lost()) {
      return "headset: the runtime %s has gone".formatted(status.runtime());
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
        status.visible() ? "" : ", not seen");
  }

  @Override
  public void close() {
    leave();
  }
}
