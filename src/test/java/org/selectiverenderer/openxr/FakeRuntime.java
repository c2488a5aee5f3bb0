package org.selectiverenderer.openxr;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import org.joml.Quaterniond;
import org.joml.Vector2d;
import org.joml.Vector3d;

/**
 * A runtime that a test holds in its hands: says what events come, where the head is, which
 * function fails, and keeps what it was asked to do. Refuses calls in an order that OpenXR does not
 * allow.
 */
final class FakeRuntime implements XrLoader {
  static final long PERIOD = 10_000_000;

  final Set<String> extensions = new HashSet<>(Set.of(XrConnection.OPENGL, XrConnection.CLOCK));
  final Deque<XrEvent> events = new ArrayDeque<>();
  final Map<String, Integer> faults = new HashMap<>();
  final Set<XrSession.SpaceKind> kinds = EnumSet.allOf(XrSession.SpaceKind.class);
  final List<Integer> formats = new ArrayList<>(List.of(0x881A, 0x8C43));
  final List<String> calls = new ArrayList<>();
  final Map<String, Boolean> buttons = new HashMap<>();
  final Map<String, Vector2d> sticks = new HashMap<>();
  final Set<String> profiles = new HashSet<>();
  SpacePose head = new SpacePose(new Vector3d(0, 1.6, 0), new Quaterniond());
  boolean headset = true;
  boolean drawn = true;
  boolean known = true;
  boolean focused = true;
  boolean eyeGaze;
  boolean gazeVouched = true;
  VisibilityMask mask = new VisibilityMask(new float[] {-1, -1.1f, 0, -1.1f, -1, 0});
  Optional<SpacePose> gaze = Optional.empty();

  /** Where hands point: 51 is the left one, 52 the right one. */
  final Map<Long, SpacePose> aims = new HashMap<>();

  long display = 1_000_000_000;
  long period = PERIOD;

  /** How long it is waited for a frame. */
  long pauseNanos;

  List<XrSession.EyePicture> shown = List.of();
  long shownAt;
  int open;

  /** The session comes to a state. */
  void state(SessionState state) {
    events.add(new XrEvent.State(state));
  }

  /** The session is shown and has the input. */
  void wear() {
    state(SessionState.IDLE);
    state(SessionState.READY);
    state(SessionState.SYNCHRONIZED);
    state(SessionState.VISIBLE);
    state(SessionState.FOCUSED);
  }

  private void call(String function) {
    calls.add(function);
    Integer code = faults.get(function);
    if (code != null) {
      throw new XrResultException(function, code);
    }
  }

  @Override
  public Set<String> extensions() {
    call("EnumerateInstanceExtensionProperties");
    return Set.copyOf(extensions);
  }

  @Override
  public XrInstance create(Set<String> enabled) {
    call("CreateInstance");
    open++;
    return new Instance();
  }

  private final class Instance implements XrInstance {
    private final Map<Long, String> actions = new HashMap<>();

    @Override
    public String runtime() {
      return "Fake 1.2.3";
    }

    @Override
    public long system() {
      call("GetSystem");
      if (!headset) {
        throw new XrResultException("GetSystem", XrResultException.FORM_FACTOR_UNAVAILABLE);
      }
      return 7;
    }

    @Override
    public SystemFacts facts(long system) {
      return new SystemFacts("Test headset", true, eyeGaze);
    }

    @Override
    public List<RecommendedImageSize> pictures(long system) {
      return List.of(new RecommendedImageSize(400, 300, 1), new RecommendedImageSize(400, 300, 1));
    }

    @Override
    public int blendMode(long system) {
      return 1;
    }

    @Override
    public XrSession session(long system, GraphicsBinding binding) {
      call("CreateSession");
      return new Session();
    }

    @Override
    public Optional<XrEvent> poll() {
      call("PollEvent");
      return Optional.ofNullable(events.poll());
    }

    @Override
    public OptionalLong now() {
      return OptionalLong.of(display - 15_000_000);
    }

    @Override
    public XrActionSystem inputs() {
      return new Inputs();
    }

    @Override
    public void close() {
      open--;
      call("DestroyInstance");
    }

    private final class Inputs implements XrActionSystem {
      @Override
      public long action(String name, String shown, Kind kind) {
        long id = 100 + actions.size();
        actions.put(id, name);
        return id;
      }

      @Override
      public void suggest(String profile, List<Map.Entry<Long, String>> bindings) {
        call("SuggestInteractionProfileBindings");
        profiles.add(profile);
      }

      @Override
      public void attach(XrSession session) {
        call("AttachSessionActionSets");
      }

      @Override
      public boolean sync() {
        call("SyncActions");
        return focused;
      }

      @Override
      public boolean button(long action) {
        return buttons.getOrDefault(actions.get(action), false);
      }

      @Override
      public Vector2d stick(long action) {
        return sticks.getOrDefault(actions.get(action), new Vector2d());
      }

      @Override
      public long space(long action) {
        return List.of("gaze", "aim_left", "aim_right").indexOf(actions.get(action)) + 50;
      }

      @Override
      public boolean active(long action) {
        return space(action) == 50 ? gaze.isPresent() : aims.containsKey(space(action));
      }

      @Override
      public Optional<String> profile(String hand) {
        return hand.endsWith("left")
            ? Optional.of("/interaction_profiles/valve/index_controller")
            : Optional.empty();
      }
    }
  }

  private final class Session implements XrSession {
    private boolean running;
    private boolean waited;
    private boolean begun;
    private final Set<Long> taken = new HashSet<>();
    private long chains = 200;

    private void require(boolean right, String function) {
      call(function);
      if (!right) {
        throw new AssertionError(function + " is not allowed now: " + calls);
      }
    }

    @Override
    public Set<SpaceKind> spaceKinds() {
      return Set.copyOf(kinds);
    }

    @Override
    public long space(SpaceKind kind) {
      calls.add("space " + kind);
      return kind.number();
    }

    @Override
    public Optional<SpacePose> locate(long space, long in, long time) {
      call("LocateSpace");
      if (space >= 50) {
        return space == 50 ? gaze : Optional.ofNullable(aims.get(space));
      }
      return known ? Optional.of(head) : Optional.empty();
    }

    @Override
    public Optional<SpacePose> tracked(long space, long in, long time) {
      return gazeVouched ? locate(space, in, time) : Optional.empty();
    }

    @Override
    public Optional<List<XrEyeView>> eyes(long in, long time) {
      call("LocateViews");
      return known ? Optional.of(List.of(eye(-0.03), eye(0.03))) : Optional.empty();
    }

    private XrEyeView eye(double x) {
      Vector3d at = head.orientation().transform(new Vector3d(x, 0, 0)).add(head.position());
      return new XrEyeView(new SpacePose(at, head.orientation()), -1, 0.9, -1.1, 1);
    }

    @Override
    public List<Integer> formats() {
      return List.copyOf(formats);
    }

    @Override
    public long swapchain(int format, int width, int height) {
      calls.add("swapchain " + Integer.toHexString(format));
      return chains++;
    }

    @Override
    public int[] textures(long swapchain) {
      return new int[] {(int) swapchain * 10, (int) swapchain * 10 + 1};
    }

    @Override
    public int acquire(long swapchain) {
      require(begun && taken.add(swapchain), "AcquireSwapchainImage");
      return 1;
    }

    @Override
    public void release(long swapchain) {
      require(taken.remove(swapchain), "ReleaseSwapchainImage");
    }

    @Override
    public void begin() {
      require(!running, "BeginSession");
      running = true;
    }

    @Override
    public void end() {
      require(running, "EndSession");
      running = false;
    }

    @Override
    public FrameTime waitFrame() {
      require(running && !waited, "WaitFrame");
      waited = true;
      display += period;
      if (pauseNanos > 0) {
        LockSupport.parkNanos(pauseNanos);
      }
      return new FrameTime(display, PERIOD, drawn);
    }

    @Override
    public void beginFrame() {
      require(waited && !begun, "BeginFrame");
      begun = true;
    }

    @Override
    public void endFrame(long at, int blendMode, long space, List<EyePicture> pictures) {
      require(begun && taken.isEmpty(), "EndFrame");
      waited = false;
      begun = false;
      shown = pictures;
      shownAt = at;
    }

    @Override
    public VisibilityMask hidden(int eye) {
      call("GetVisibilityMaskKHR");
      return mask;
    }

    @Override
    public void close() {
      call("DestroySession");
    }
  }
}
