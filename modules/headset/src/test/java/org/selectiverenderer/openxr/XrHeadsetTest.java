package org.selectiverenderer.openxr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.openxr.HeadsetEvent.Kind;

class XrHeadsetTest {
  private static final GraphicsBinding BINDING = new GraphicsBinding.Windows(1, 2);
  private static final long SECOND = 1_000_000_000;

  private final FakeRuntime runtime = new FakeRuntime();
  private final List<HeadsetEvent> news = new ArrayList<>();
  private long nanos;

  private XrHeadset show(Posture posture) throws HeadsetUnavailableException {
    return new XrHeadset(
        runtime, XrConnection.open(runtime), BINDING, posture, news::add, () -> nanos);
  }

  private XrHeadset worn() throws HeadsetUnavailableException {
    XrHeadset headset = show(Posture.STANDING);
    runtime.wear();
    frame(headset);
    return headset;
  }

  /** A whole frame with both pictures, if one is due. */
  private Optional<XrFrame> frame(XrHeadset headset) {
    Optional<XrFrame> due = headset.next();
    if (due.isPresent()) {
      headset.begin();
      boolean both = headset.acquire(0).isPresent() & headset.acquire(1).isPresent();
      headset.end(both);
    }
    return due;
  }

  private List<Kind> kinds() {
    return news.stream().map(HeadsetEvent::kind).toList();
  }

  @Test
  void showsNothingBeforeTheSessionIsReady() throws Exception {
    XrHeadset headset = show(Posture.STANDING);
    runtime.state(SessionState.IDLE);
    assertTrue(frame(headset).isEmpty());
    assertFalse(headset.visible());
    assertEquals(List.of(Kind.FOUND), kinds());
    runtime.state(SessionState.READY);
    assertTrue(frame(headset).isPresent());
    assertFalse(headset.visible());
    runtime.state(SessionState.SYNCHRONIZED);
    runtime.state(SessionState.FOCUSED);
    frame(headset);
    assertTrue(headset.visible());
    assertEquals(List.of(Kind.FOUND, Kind.WORN), kinds());
  }

  @Test
  void tellsWhereHeadAndEyesWillBe() throws Exception {
    runtime.head =
        new XrPose(new Vector3d(1, 1.7, 2), new Quaterniond().rotationY(Math.toRadians(90)));
    XrHeadset headset = worn();
    XrFrame due = frame(headset).orElseThrow();
    assertEquals(runtime.display, due.display());
    assertEquals(1.7, due.head().position().y, 1e-12);
    assertTrue(due.floor());
    assertEquals(15_000_000, due.lead());
    assertEquals(-0.03, due.eyes().get(0).pose().position().x, 1e-12);
    assertEquals(0, due.eyes().get(0).pose().position().z, 1e-12);
    assertEquals(1, due.eyes().get(1).pose().orientation().w, 1e-12);
    assertEquals(0.9, due.eyes().get(1).right(), 0);
  }

  @Test
  void handsOverTheEyesThatWereDrawnFromAtTheirTime() throws Exception {
    XrHeadset headset = worn();
    headset.next();
    long due = runtime.display;
    headset.begin();
    assertEquals(Optional.of(2001), headset.acquire(0));
    assertEquals(Optional.of(2011), headset.acquire(1));
    runtime.head = new XrPose(new Vector3d(9, 9, 9), new Quaterniond());
    headset.end(true);
    assertEquals(due, runtime.shownAt);
    assertEquals(2, runtime.shown.size());
    assertEquals(-0.03, runtime.shown.get(0).sight().pose().position().x, 1e-12);
    assertEquals(400, runtime.shown.get(0).width());
  }

  @Test
  void framesThatNobodySeesHaveNoPictures() throws Exception {
    XrHeadset headset = worn();
    headset.next();
    headset.begin();
    headset.end(false);
    assertEquals(List.of(), runtime.shown);
    runtime.known = false; // As before the tracking has begun.
    assertTrue(frame(headset).isEmpty());
    assertEquals("EndFrame", runtime.calls.get(runtime.calls.size() - 1));
  }

  @Test
  void standsOnTheFloorWhereTheRuntimeKnowsOne() throws Exception {
    show(Posture.STANDING);
    assertTrue(runtime.calls.contains("space STAGE"));
    runtime.calls.clear();
    show(Posture.SEATED);
    assertTrue(runtime.calls.contains("space LOCAL"));
    runtime.calls.clear();
    runtime.kinds.remove(XrSession.SpaceKind.STAGE);
    XrHeadset headset = show(Posture.STANDING);
    assertTrue(runtime.calls.contains("space LOCAL"));
    runtime.wear();
    assertFalse(frame(headset).orElseThrow().floor());
  }

  @Test
  void colorsAreHandedOverAsWhatTheyAre() {
    assertEquals(0x8C43, EyeSwapchains.format(List.of(0x881A, 0x8058, 0x8C43)));
    assertEquals(0x8058, EyeSwapchains.format(List.of(0x881A, 0x8058)));
    assertEquals(0x881A, EyeSwapchains.format(List.of(0x881A)));
  }

  @Test
  void tellsWhenItIsTakenOffAndCovered() throws Exception {
    XrHeadset headset = worn();
    runtime.state(SessionState.VISIBLE);
    frame(headset);
    assertTrue(headset.visible());
    runtime.state(SessionState.SYNCHRONIZED);
    frame(headset);
    assertFalse(headset.visible());
    runtime.state(SessionState.STOPPING);
    runtime.state(SessionState.IDLE);
    assertTrue(frame(headset).isEmpty());
    runtime.state(SessionState.READY);
    runtime.state(SessionState.FOCUSED);
    assertTrue(frame(headset).isPresent());
    assertEquals(List.of(Kind.FOUND, Kind.WORN, Kind.COVERED, Kind.AWAY, Kind.WORN), kinds());
  }

  @Test
  void aHeadsetThatLiesOnTheTableIsNotSeen() throws Exception {
    XrHeadset headset = worn();
    runtime.events.add(new XrEvent.Presence(false));
    frame(headset);
    assertFalse(headset.visible());
    runtime.events.add(new XrEvent.Presence(true));
    frame(headset);
    assertTrue(headset.visible());
    assertEquals(List.of(Kind.FOUND, Kind.WORN, Kind.AWAY, Kind.WORN), kinds());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "PollEvent",
        "WaitFrame",
        "LocateSpace",
        "LocateViews",
        "SyncActions",
        "BeginFrame",
        "AcquireSwapchainImage",
        "ReleaseSwapchainImage",
        "EndFrame"
      })
  void aRuntimeThatDiesInAnyCallIsLookedForUntilItIsBack(String function) throws Exception {
    XrHeadset headset = worn();
    runtime.faults.put(function, XrResultException.INSTANCE_LOST);
    frame(headset);
    assertEquals(List.of(Kind.FOUND, Kind.WORN, Kind.LOST), kinds());
    assertTrue(news.get(2).text().contains("xr" + function));
    assertEquals(0, runtime.open);
    runtime.faults.put("CreateInstance", XrResultException.RUNTIME_FAILURE);
    nanos += SECOND;
    assertTrue(frame(headset).isEmpty());
    assertTrue(headset.status().lost());
    runtime.faults.clear();
    assertTrue(frame(headset).isEmpty()); // Not before the next second.
    nanos += SECOND;
    frame(headset);
    runtime.wear();
    assertTrue(frame(headset).isPresent());
    assertEquals(List.of(Kind.FOUND, Kind.WORN, Kind.LOST, Kind.FOUND, Kind.WORN), kinds());
    assertFalse(headset.status().lost());
  }

  @Test
  void aRuntimeThatSaysThatItEndsIsLetGo() throws Exception {
    XrHeadset headset = worn();
    runtime.state(SessionState.LOSS_PENDING);
    assertTrue(frame(headset).isEmpty());
    nanos += SECOND;
    frame(headset);
    runtime.events.add(new XrEvent.InstanceLoss());
    assertTrue(frame(headset).isEmpty());
    assertEquals(List.of(Kind.FOUND, Kind.WORN, Kind.LOST, Kind.FOUND, Kind.LOST), kinds());
  }

  @Test
  void aRuntimeThatDiesWhileItBeginsIsLookedForToo() throws Exception {
    runtime.faults.put("CreateSession", -38);
    XrHeadset headset = show(Posture.STANDING);
    assertEquals(List.of(Kind.LOST), kinds());
    runtime.faults.clear();
    nanos += SECOND;
    frame(headset);
    runtime.wear();
    assertTrue(frame(headset).isPresent());
  }

  @Test
  void theRuntimeMayAskTheProgramToEnd() throws Exception {
    XrHeadset headset = worn();
    runtime.state(SessionState.STOPPING);
    runtime.state(SessionState.EXITING);
    assertTrue(frame(headset).isEmpty());
    assertEquals(Kind.LEAVE, news.get(2).kind());
    assertEquals(0, runtime.open);
  }

  @Test
  void recentringIsToldOnce() throws Exception {
    XrHeadset headset = worn();
    assertTrue(headset.takeRecentred());
    assertFalse(headset.takeRecentred());
    runtime.events.add(new XrEvent.Recentred());
    frame(headset);
    assertTrue(headset.takeRecentred());
    assertEquals(Kind.RECENTRED, news.get(2).kind());
  }

  @Test
  void countsFramesThatWereNotReadyInTime() throws Exception {
    XrHeadset headset = worn();
    frame(headset);
    runtime.period = 3 * FakeRuntime.PERIOD;
    frame(headset);
    runtime.period = FakeRuntime.PERIOD;
    frame(headset);
    XrHeadsetStatus status = headset.status();
    assertEquals(100, status.rate(), 1e-9);
    assertEquals(4, status.frames());
    assertEquals(2, status.missed());
    assertEquals(15, status.leadMs(), 1e-9);
    assertEquals(
        "headset: Fake 1.2.3, 100 Hz, 2 of 4 frames missed, pose 15 ms ahead",
        XrHeadset.describe(status));
  }

  @Test
  void framesWhileNobodyLooksAreNotMissed() throws Exception {
    XrHeadset headset = worn();
    runtime.drawn = false;
    runtime.period = 50 * FakeRuntime.PERIOD;
    frame(headset);
    runtime.drawn = true;
    frame(headset);
    assertEquals(0, headset.status().missed());
  }

  @Test
  void readsWhatHandsDo() throws Exception {
    XrHeadset headset = worn();
    runtime.sticks.put("walk", new Vector2d(0.1, 1));
    runtime.sticks.put("turn", new Vector2d(-1, 0));
    runtime.buttons.put("yes", true);
    XrInputState input = frame(headset).orElseThrow().input();
    assertEquals(1, input.forward(), 1e-9);
    assertEquals(0, input.side(), 1e-9); // A stick that rests is never quite in its middle.
    assertEquals(-1, input.turn(), 1e-9);
    assertEquals(Set.of(ControllerAction.YES), input.held());
    runtime.focused = false;
    assertEquals(XrInputState.NONE, frame(headset).orElseThrow().input());
    runtime.events.add(new XrEvent.ControllersChanged());
    frame(headset);
    assertEquals("the headset's controls are Index controllers", news.get(2).text());
  }

  @Test
  void readsWhereTheEyesLook() throws Exception {
    runtime.extensions.add(XrActionBindings.GAZE);
    runtime.eyeGaze = true;
    runtime.gaze =
        Optional.of(new XrPose(new Vector3d(), new Quaterniond().rotationX(Math.PI / 2)));
    XrHeadset headset = worn();
    Vector3d looked = frame(headset).orElseThrow().input().gaze().orElseThrow();
    assertEquals(1, looked.y, 1e-9);
    runtime.gazeVouched = false;
    assertTrue(frame(headset).orElseThrow().input().gaze().isEmpty());
    runtime.gazeVouched = true;
    assertTrue(frame(headset).orElseThrow().input().gaze().isPresent());
    runtime.gaze = Optional.empty();
    assertTrue(frame(headset).orElseThrow().input().gaze().isEmpty());
  }

  @Test
  void readsWhereEachHandPoints() throws Exception {
    XrPose right = new XrPose(new Vector3d(0.2, -0.3, -0.4), new Quaterniond().rotationX(0.3));
    runtime.aims.put(52L, right);
    runtime.buttons.put("choose_right", true);
    XrInputState input = frame(worn()).orElseThrow().input();
    assertTrue(input.left().isEmpty());
    assertEquals(right, input.right().orElseThrow());
    assertEquals(Set.of(ControllerAction.CHOOSE_RIGHT), input.held());
  }

  @Test
  void tellsWhetherTheHeadsetTracksTheEyes() throws Exception {
    assertFalse(XrHeadsetFinder.begin(runtime).tracksEyes());
    runtime.eyeGaze = true;
    assertFalse(XrHeadsetFinder.begin(runtime).tracksEyes()); // The runtime would not tell.
    runtime.extensions.add(XrActionBindings.GAZE);
    assertTrue(XrHeadsetFinder.begin(runtime).tracksEyes());
  }

  @Test
  void aRuntimeNeedNotKnowAllControllers() throws Exception {
    runtime.faults.put("SuggestInteractionProfileBindings", -22);
    assertTrue(worn().visible());
    runtime.faults.clear();
    worn();
    assertTrue(runtime.profiles.contains("/interaction_profiles/oculus/touch_controller"));
    assertFalse(runtime.profiles.contains("/interaction_profiles/ext/hand_interaction_ext"));
  }

  @Test
  void readsWhatTheLensesHideAndReadsItAgainWhenTheyChange() throws Exception {
    assertTrue(worn().hidden().isEmpty());
    runtime.extensions.add(XrConnection.MASK);
    XrHeadset headset = worn();
    List<VisibilityMask> first = headset.hidden();
    assertEquals(List.of(runtime.mask, runtime.mask), first);
    headset.next();
    headset.begin();
    headset.end(false);
    assertSame(first, headset.hidden());
    runtime.mask = VisibilityMask.NONE;
    runtime.events.add(new XrEvent.MaskChanged());
    headset.next();
    assertEquals(List.of(VisibilityMask.NONE, VisibilityMask.NONE), headset.hidden());
  }

  @Test
  void letsGoOfTheRuntimeInTheEnd() throws Exception {
    XrHeadset headset = worn();
    headset.close();
    assertEquals(0, runtime.open);
    assertTrue(runtime.calls.contains("DestroySession"));
  }

  private String missing() {
    return assertThrows(HeadsetUnavailableException.class, () -> XrHeadsetFinder.begin(runtime))
        .getMessage();
  }

  @Test
  void saysWhatIsMissingAndWhatToDo() throws Exception {
    runtime.faults.put(
        "EnumerateInstanceExtensionProperties", XrResultException.RUNTIME_UNAVAILABLE);
    assertTrue(missing().startsWith("no OpenXR runtime is set up on this computer: install"));
    runtime.faults.clear();
    runtime.faults.put("CreateInstance", XrResultException.RUNTIME_FAILURE);
    assertTrue(missing().contains("does not answer (xrCreateInstance: XR_ERROR_RUNTIME_FAILURE)"));
    runtime.faults.clear();
    runtime.headset = false;
    assertEquals(
        "the OpenXR runtime Fake 1.2.3 finds no headset: connect it, switch it on and try again",
        missing());
    assertEquals(0, runtime.open);
    runtime.headset = true;
    runtime.extensions.remove(XrConnection.OPENGL);
    assertTrue(missing().contains("lacks XR_KHR_opengl_enable"));
  }

  @Test
  void whatWasFoundAndNotShownIsLetGo() throws Exception {
    try (XrHeadsetFinder search = XrHeadsetFinder.begin(runtime)) {
      assertEquals("Test headset", search.headset());
      assertEquals(new RecommendedImageSize(400, 300, 1), search.size());
    }
    assertEquals(0, runtime.open);
  }

  @Test
  void adviceWithoutARuntimeFitsTheSystem() {
    assertTrue(XrConnection.missing("Linux").contains("SteamVR or Monado and make it"));
    assertTrue(XrConnection.missing("Windows 11").contains("headset's maker or SteamVR and make"));
    assertFalse(XrConnection.missing("Windows 11").contains("Monado"));
  }
}
