package example;

import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.control.SelectiveController.Settings;

/** Lets the controller choose the versions of objects in a browser that is not the program's. */
public final class WalkToTheDesk {
  private WalkToTheDesk() {}

  public static void main(String[] args) {
    TinyBrowser browser = new TinyBrowser(); // In its place: Xj3D's, or your own.
    try (SelectiveController controller =
        new SelectiveController(
            browser.external(), Settings.SELECTIVE, System.out::println, System.out::println)) {
      browser.enterDesk(1);
      System.out.println(controller.enteredAreas() + " " + controller.choices());
      browser.leaveDesk(2);
      System.out.println(controller.enteredAreas() + " " + controller.choices());
    }
  }
}
