package org.selectiverenderer.render.window;

import com.jogamp.nativewindow.NativeWindowException;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.nativewindow.util.RectangleImmutable;
import com.jogamp.newt.Display;
import com.jogamp.newt.MonitorDevice;
import com.jogamp.newt.NewtFactory;
import com.jogamp.newt.Screen;
import com.jogamp.newt.util.EDTUtil;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;
import jogamp.nativewindow.x11.X11Lib;
import org.selectiverenderer.render.context.JoglNativeLibraries;

/** Lists the monitors of the desktop. GL must be available ({@code GlAvailability}). */
public final class Monitors {
  private Monitors() {}

  /**
   * Returns all monitors, sorted by screen, from left to right and from top to bottom.
   *
   * @throws UncheckedIOException if the system describes a monitor in a way that JOGL cannot use
   */
  public static List<Monitor> all() {
    return modes().stream().map(MonitorMode::monitor).toList();
  }

  /**
   * Returns all monitors with refresh rate and scale, in the same order.
   *
   * @throws UncheckedIOException if the system describes a monitor in a way that JOGL cannot use
   */
  public static List<MonitorMode> modes() {
    JoglNativeLibraries.use();
    return explained(Monitors::list);
  }

  /**
   * Says in a sentence what is wrong where JOGL refuses a description of a monitor, such as that of
   * Wine, whose monitors joined to one have modes without a size.
   */
  static List<MonitorMode> explained(Supplier<List<MonitorMode>> list) {
    try {
      return list.get();
    } catch (IllegalArgumentException | NativeWindowException e) {
      throw new UncheckedIOException(
          new IOException(
              "the monitors cannot be listed, since the system or its driver describes one that"
                  + " cannot be ("
                  + e.getMessage()
                  + "); set them up anew in the system's display settings, or update the driver",
              e));
    }
  }

  private static List<MonitorMode> list() {
    List<MonitorMode> monitors = new ArrayList<>();
    Display display = NewtFactory.createDisplay(null);
    int screens = 1;
    for (int index = 0; index < screens; index++) {
      Screen screen = NewtFactory.createScreen(display, index);
      screen.addReference();
      try {
        if (index == 0) {
          screens = screens(display);
        } else if (screen.getIndex() != index) {
          break; // Xinerama joins all screens into the first.
        }
        for (MonitorDevice device : screen.getMonitorDevices()) {
          RectangleImmutable at = device.getViewportInWindowUnits();
          Monitor monitor =
              new Monitor(
                  index,
                  device.getId(),
                  device.getName(),
                  at.getX(),
                  at.getY(),
                  at.getWidth(),
                  at.getHeight());
          monitors.add(
              new MonitorMode(monitor, device.getCurrentMode().getRefreshRate(), scale(device)));
        }
      } finally {
        letGo(screen);
      }
    }
    monitors.sort(
        Comparator.comparing(
            MonitorMode::monitor,
            Comparator.comparingInt(Monitor::screen)
                .thenComparingInt(Monitor::x)
                .thenComparingInt(Monitor::y)));
    return monitors;
  }

  private static float scale(MonitorDevice device) {
    return device.getPixelScale(new float[2])[0];
  }

  /**
   * Returns the number of screens, which NEWT does not tell; for a screen that does not exist NEWT
   * gives wrong answers.
   */
  private static int screens(Display display) {
    return NativeWindowFactory.TYPE_X11.equals(NativeWindowFactory.getNativeWindowType(true))
        ? X11Lib.ScreenCount(display.getHandle())
        : 1;
  }

  /**
   * Releases a reference to a screen. The last reference closes its display, which must happen on
   * the thread that polls the display for events: otherwise that thread polls a closed display.
   */
  static void letGo(Screen screen) {
    Display display = screen.getDisplay();
    EDTUtil events = display.getEDTUtil();
    if (events == null || !events.isRunning()) {
      screen.removeReference();
      return;
    }
    events.invoke(true, screen::removeReference);
    if (!display.isNativeValid()) {
      events.waitUntilStopped();
    }
  }

  /** Returns the screen that a monitor belongs to. */
  static Screen screen(Monitor monitor) {
    return NewtFactory.createScreen(NewtFactory.createDisplay(null), monitor.screen());
  }

  /**
   * Returns NEWT's device of a monitor, or all devices of the screen if it is unknown; the screen
   * must be open.
   */
  static List<MonitorDevice> device(Screen screen, Monitor monitor) {
    MonitorDevice device = screen.getMonitorById(monitor.id());
    return device == null ? screen.getMonitorDevices() : List.of(device);
  }
}
