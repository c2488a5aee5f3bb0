package org.selectiverenderer.app.headset;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.metrics.HeadsetMetrics;
import org.selectiverenderer.apparatus.EyeFrustum;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import org.selectiverenderer.openxr.GraphicsBinding;
import org.selectiverenderer.openxr.HeadsetEvent;
import org.selectiverenderer.openxr.HeadsetUnavailableException;
import org.selectiverenderer.openxr.Posture;
import org.selectiverenderer.openxr.RecommendedImageSize;
import org.selectiverenderer.openxr.VisibilityMask;
import org.selectiverenderer.openxr.XrEyeView;
import org.selectiverenderer.openxr.XrFrame;
import org.selectiverenderer.openxr.XrHeadset;
import org.selectiverenderer.openxr.XrHeadsetFinder;
import org.selectiverenderer.openxr.XrHeadsetStatus;
import org.selectiverenderer.render.headset.GlContextHandles;
import org.selectiverenderer.render.headset.HeadsetDisplay;
import org.selectiverenderer.tracker.LatencyHistogram;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.pipeline.HeadsetPoseTracker;

/**
 * The connection to the headset of a run, or of all runs of a session. It is made by the thread
 * that begins the run; after that, all methods but {@link #tracker} belong to the thread that shows
 * the frames.
 */
public final class HeadsetConnection implements HeadsetDisplay {
  private final XrHeadsetFinder search;
  private final HeadsetViewSettings shown;
  private final HeadsetControllers hands;
  private final PoseSample pose = new PoseSample();
  private final AtomicReference<XrHeadsetStatus> status =
      new AtomicReference<>(XrHeadsetStatus.NONE);
  private final LatencyHistogram lead = new LatencyHistogram();
  private final List<HeadsetEvent> news = new ArrayList<>();
  private Supplier<@Nullable HeadsetPoseTracker> tracker = () -> null;
  private @Nullable XrHeadset headset;
  private List<VisibilityMask> hidden = List.of();
  private Optional<Vector3d> gaze = Optional.empty();
  private boolean leave;

  private HeadsetConnection(XrHeadsetFinder search, HeadsetViewSettings shown) {
    this.search = search;
    this.shown = shown;
    hands = new HeadsetControllers(shown.turnStep());
  }

  /**
   * Finds the headset of this computer.
   *
   * @throws HeadsetUnavailableException with a sentence that says what is missing and what to do
   */
  public static HeadsetConnection find(HeadsetViewSettings shown)
      throws HeadsetUnavailableException {
    return with(XrHeadsetFinder.begin(), shown);
  }

  /**
   * Creates a connection to a headset that was found.
   *
   * @param search the found headset; closed with the connection
   */
  public static HeadsetConnection with(XrHeadsetFinder search, HeadsetViewSettings shown) {
    return new HeadsetConnection(search, shown);
  }

  /** Returns headset, runtime and picture size in a sentence. */
  public String describe() {
    RecommendedImageSize size = search.size();
    return "headset %s by %s, pictures of %dx%d for each eye%s"
        .formatted(
            search.headset(),
            search.runtime(),
            size.width(),
            size.height(),
            search.tracksEyes() ? ", tracks the eyes" : "");
  }

  /** Returns whether the headset has an eye tracker that the program may use. */
  public boolean tracksEyes() {
    return search.tracksEyes();
  }

  /**
   * Creates the tracker of the head; to be called once, before the headset is opened.
   *
   * @param listener receives every pose, on the thread that shows frames
   */
  public HeadsetPoseTracker tracker(TrackerListener listener) {
    HeadsetPoseTracker made = new HeadsetPoseTracker(listener, this::described);
    tracker = () -> made;
    return made;
  }

  /**
   * Passes the poses to a tracker that exists already.
   *
   * @param to supplies the tracker; null until there is one
   */
  public void feed(Supplier<@Nullable HeadsetPoseTracker> to) {
    tracker = to;
  }

  /** Returns the headset's status as a line of text; may be called on any thread. */
  public String described() {
    return XrHeadset.describe(status.get());
  }

  /**
   * Returns the performance measurements since the headset was opened, for all runs of a session
   * together.
   */
  public HeadsetMetrics figures() {
    XrHeadsetStatus now = status.get();
    return new HeadsetMetrics(now.runtime(), now.rate(), now.frames(), now.missed(), lead);
  }

  /** Returns the hand controllers. */
  public HeadsetControllers hands() {
    return hands;
  }

  /**
   * Returns the direction of gaze in the frame that is due, a unit vector in head coordinates;
   * empty while the eye tracker does not see the eyes.
   */
  public Optional<Vector3d> gaze() {
    return gaze;
  }

  /** Removes and returns the headset's events since the last call, in order. */
  public List<HeadsetEvent> takeNews() {
    List<HeadsetEvent> taken = List.copyOf(news);
    news.clear();
    return taken;
  }

  @Override
  public void open(GlContextHandles handles) {
    Consumer<HeadsetEvent> hear = this::heard;
    headset =
        search.show(binding(handles), shown.seated() ? Posture.SEATED : Posture.STANDING, hear);
  }

  private static GraphicsBinding binding(GlContextHandles handles) {
    if (handles instanceof GlContextHandles.Glx x) {
      return new GraphicsBinding.Xlib(
          x.display(), x.visual(), x.fbConfig(), x.drawable(), x.context());
    }
    GlContextHandles.Wgl windows = (GlContextHandles.Wgl) handles;
    return new GraphicsBinding.Windows(windows.device(), windows.context());
  }

  private void heard(HeadsetEvent told) {
    news.add(told);
    leave |= told.kind() == HeadsetEvent.Kind.LEAVE;
  }

  private XrHeadset opened() {
    XrHeadset known = headset;
    if (known == null) {
      throw new IllegalStateException("the headset is not open yet");
    }
    return known;
  }

  @Override
  public Optional<Due> next() {
    XrHeadset open = opened();
    Optional<XrFrame> frame = open.next();
    long now = System.nanoTime();
    status.set(open.status());
    HeadsetPoseTracker fed = tracker.get();
    if (open.takeRecentred() && fed != null) {
      fed.straighten();
    }
    if (frame.isEmpty()) {
      hands.rest();
      gaze = Optional.empty();
      if (fed != null) {
        fed.pause(open.status().lost());
      }
      return Optional.empty();
    }
    hide(open.hidden());
    take(frame.get(), fed, now);
    return open.size().map(size -> new Due(size.width(), size.height(), frame.get().drawn()));
  }

  private void hide(List<VisibilityMask> told) {
    if (told != hidden) {
      hidden = told;
      shown.layout().hidden(told.stream().map(VisibilityMask::corners).toList());
    }
  }

  private void take(XrFrame frame, @Nullable HeadsetPoseTracker fed, long now) {
    if (frame.lead() >= 0) {
      lead.record(frame.lead());
    }
    HeadsetLayout layout = shown.layout();
    layout.floor(frame.floor());
    layout.eyes(frame.eyes().stream().map(HeadsetConnection::eye).toList());
    hands.frame(frame.input());
    gaze = frame.input().gaze();
    Quaterniond turn = frame.head().orientation();
    Vector3d at = frame.head().position();
    pose.turn(turn.x, turn.y, turn.z, turn.w);
    pose.place(at.x, at.y, at.z);
    if (fed != null) {
      fed.hand(pose, now);
    }
  }

  private static HeadsetLayout.EyeAt eye(XrEyeView sight) {
    return new HeadsetLayout.EyeAt(
        sight.pose().position(),
        sight.pose().orientation(),
        new EyeFrustum(sight.left(), sight.right(), sight.bottom(), sight.top()));
  }

  @Override
  public boolean visible() {
    return opened().visible();
  }

  @Override
  public ViewLayout layout() {
    return shown.layout();
  }

  @Override
  public void begin() {
    opened().begin();
  }

  @Override
  public OptionalInt texture(int eye) {
    return opened().acquire(eye).map(OptionalInt::of).orElseGet(OptionalInt::empty);
  }

  @Override
  public void end(boolean drawn) {
    opened().end(drawn);
  }

  @Override
  public boolean takeLeave() {
    boolean was = leave;
    leave = false;
    return was;
  }

  @Override
  public void close() {
    if (headset != null) {
      headset.close();
    }
    search.close();
  }
}
