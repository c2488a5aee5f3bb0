package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.control.ControlledSceneFixture.area;
import static org.selectiverenderer.control.ControlledSceneFixture.object;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent.Enter;
import org.selectiverenderer.control.ControlEvent.Exit;
import org.selectiverenderer.control.ControlEvent.Start;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.testing.Eventually;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEvent;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;

/**
 * A browser may deliver events some time after they happened, and by several threads, as Xj3D does:
 * here the test delivers those of a sensor.
 */
class LateEventsTest {
  private static final String SCENE =
      area("DeskProx", 0, "DeskSchema", "OfficeSchema")
          + object("DEF='TrashCan'", "DeskSchema", "OfficeSchema");

  /** The name of a node that the scene does not name: the one that stands in for DeskProx. */
  private static final String AREA = "ProximitySensor#1";

  private static final double OUTSIDE = -5;
  private static final double AT_DESK = 0;

  private X3DFieldEventListener onEnter;
  private X3DFieldEventListener onExit;

  /** A browser whose sensor tells nobody but the test. */
  private ExternalBrowser browser(ControlledSceneFixture scene) {
    X3DNode sensor =
        standIn(
            ProximitySensor.class,
            scene.node("DeskProx"),
            "getField",
            name ->
                switch ((String) name) {
                  case "enterTime" -> silent(listener -> onEnter = listener);
                  case "exitTime" -> silent(listener -> onExit = listener);
                  default -> scene.node("DeskProx").getField((String) name);
                });
    X3DNode[] roots = {sensor, scene.node("TrashCan")};
    X3DScene world = standIn(X3DScene.class, scene.scene(), "getRootNodes", none -> roots);
    return standIn(ExternalBrowser.class, scene.browser, "getExecutionContext", none -> world);
  }

  private static X3DField silent(Consumer<X3DFieldEventListener> listeners) {
    return (X3DField)
        Proxy.newProxyInstance(
            X3DField.class.getClassLoader(),
            new Class<?>[] {X3DField.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("addX3DEventListener")) {
                listeners.accept((X3DFieldEventListener) arguments[0]);
              }
              return null;
            });
  }

  @FunctionalInterface
  private interface Answer {
    Object to(Object argument);
  }

  private static <T> T standIn(Class<T> type, Object other, String name, Answer answer) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            (proxy, method, arguments) -> {
              if (method.getName().equals(name)) {
                return answer.to(arguments == null ? null : arguments[0]);
              }
              try {
                return method.invoke(other, arguments);
              } catch (InvocationTargetException e) {
                throw e.getCause();
              }
            }));
  }

  private static void deliver(X3DFieldEventListener listener, double time) {
    listener.readableFieldChanged(new X3DFieldEvent("test", time, null));
  }

  private void control(ControlledSceneFixture scene, Consumer<ControlEvent> events) {
    scene.controller =
        new SelectiveController(browser(scene), Settings.SELECTIVE, events, scene.problems::add);
  }

  @Test
  void anEntryThatTheSensorHasShownAlreadyIsToldOnce() {
    try (var scene = new ControlledSceneFixture(SCENE)) {
      scene.walkTo(AT_DESK);
      control(scene, scene.events::add);
      assertThat(scene.news())
          .containsExactly(
              new Start(0, Map.of("TrashCan", 1)),
              new Enter(1, AREA, List.of("DeskSchema")),
              new SwitchChange(1, "TrashCan", 1, 0, "DeskSchema"));
      deliver(onEnter, 1);
      assertThat(scene.news()).isEmpty();

      deliver(onExit, 2);
      assertThat(scene.news()).hasSize(2).first().isInstanceOf(Exit.class);
      deliver(onEnter, 3);
      assertThat(scene.news()).hasSize(2).first().isInstanceOf(Enter.class);
    }
  }

  @Test
  void anExitFromBeforeTheControlBeganIsNotTold() {
    try (var scene = new ControlledSceneFixture(SCENE)) {
      scene.walkTo(AT_DESK);
      scene.walkTo(OUTSIDE);
      control(scene, scene.events::add);
      assertThat(scene.news()).containsExactly(new Start(0, Map.of("TrashCan", 1)));
      deliver(onExit, 2);
      assertThat(scene.news()).isEmpty();
    }
  }

  @Test
  void whatComesAfterTheEndChangesNothing() {
    try (var scene = new ControlledSceneFixture(SCENE)) {
      control(scene, scene.events::add);
      scene.controller.close();
      scene.news();
      deliver(onEnter, 1);
      assertThat(scene.news()).isEmpty();
      assertThat(scene.choice("TrashCan")).isEqualTo(1);
    }
  }

  @Test
  void eventsOfSeveralThreadsAreToldOneAfterTheOther() throws InterruptedException {
    try (var scene = new ControlledSceneFixture(SCENE)) {
      CountDownLatch entering = new CountDownLatch(1);
      CountDownLatch goOn = new CountDownLatch(1);
      Consumer<ControlEvent> events =
          event -> {
            scene.events.add(event);
            if (event instanceof Enter) {
              entering.countDown();
              await(goOn);
            }
          };
      control(scene, events);
      scene.news();
      Thread first = new Thread(() -> deliver(onEnter, 1), "first");
      Thread second = new Thread(() -> deliver(onExit, 2), "second");
      first.start();
      await(entering);
      second.start();
      Eventually.await(
          "the second thread to wait for the first",
          () -> !second.isAlive() || second.getState() == Thread.State.BLOCKED);
      goOn.countDown();
      first.join();
      second.join();
      assertThat(scene.news())
          .containsExactly(
              new Enter(1, AREA, List.of("DeskSchema")),
              new SwitchChange(1, "TrashCan", 1, 0, "DeskSchema"),
              new Exit(2, AREA, List.of("OfficeSchema")),
              new SwitchChange(2, "TrashCan", 0, 1, "OfficeSchema"));
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
