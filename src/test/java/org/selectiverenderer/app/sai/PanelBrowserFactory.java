package org.selectiverenderer.app.sai;

import java.awt.EventQueue;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.net.InetAddress;
import java.util.Map;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.selectiverenderer.browser.sai.EmbeddedBrowserFactory;
import org.web3d.x3d.sai.BrowserFactoryImpl;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;

/**
 * Makes browsers like Xj3D's: each is a Swing panel. It closes the window that it is put into and
 * prints what an observer would see.
 */
public final class PanelBrowserFactory implements BrowserFactoryImpl {
  @Override
  public X3DComponent createComponent(Map<String, Object> parameters) {
    System.out.println("parameters: " + parameters);
    return new Panel(new EmbeddedBrowserFactory().createComponent(parameters));
  }

  @Override
  public ExternalBrowser getBrowser(InetAddress address, int port) {
    throw new NotSupportedException("browsers on other machines");
  }

  private static final class Panel extends JPanel implements X3DComponent {
    private static final long serialVersionUID = 1;

    private final transient X3DComponent embedded;

    Panel(X3DComponent embedded) {
      this.embedded = embedded;
    }

    @Override
    public void addNotify() {
      super.addNotify();
      EventQueue.invokeLater(this::closeWindow);
    }

    private void closeWindow() {
      Window window = SwingUtilities.getWindowAncestor(this);
      System.out.println("shown: " + window.isShowing());
      window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
    }

    @Override
    public ExternalBrowser getBrowser() {
      return embedded.getBrowser();
    }

    @Override
    public Object getImplementation() {
      return embedded.getImplementation();
    }

    @Override
    public void shutdown() {
      embedded.shutdown();
    }
  }
}
