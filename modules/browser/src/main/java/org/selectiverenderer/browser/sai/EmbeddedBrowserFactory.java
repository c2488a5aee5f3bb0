package org.selectiverenderer.browser.sai;

import java.net.InetAddress;
import java.util.Map;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.web3d.x3d.sai.BrowserFactoryImpl;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.X3DComponent;

/** Makes embedded browsers for applications that use only the SAI. */
public final class EmbeddedBrowserFactory implements BrowserFactoryImpl {
  /** The key of a parameter: a {@code Consumer<String>} that receives what applications print. */
  public static final String CONSOLE = "org.selectiverenderer.console";

  /** The key of a parameter: a {@code Consumer<Problem>} that receives the problems of files. */
  public static final String PROBLEMS = "org.selectiverenderer.problems";

  @Override
  public X3DComponent createComponent(Map<String, Object> parameters) {
    ProblemCollector problems = new ProblemCollector(consumer(parameters, PROBLEMS, Problem.class));
    NodeCatalogue catalogue = NodeCatalogue.load();
    NodeFactory factory = new NodeFactory();
    SceneLoader loader = new SceneLoader(catalogue, factory, ReadLimits.standard(), problems);
    Scene empty =
        new Scene(
            factory.make(catalogue.get("Group"), null, SourceLocation.of("(empty)")),
            "",
            "4.0",
            "Full",
            Map.of(),
            1);
    World world = new World(new LoadedScene(empty, loader), problems);
    world.epoch(System.currentTimeMillis() / 1000.0);
    EmbeddedBrowser browser =
        new EmbeddedBrowser(
            world, loader, consumer(parameters, CONSOLE, String.class), Map.of("Renderer", "none"));
    return new EmbeddedComponent(world, loader, browser);
  }

  /** Returns the consumer among the parameters; one that does nothing when there is none. */
  @SuppressWarnings("unchecked")
  private static <T> Consumer<T> consumer(Map<String, Object> parameters, String key, Class<T> of) {
    return parameters != null && parameters.get(key) instanceof Consumer<?> consumer
        ? (Consumer<T>) consumer
        : value -> {};
  }

  @Override
  public ExternalBrowser getBrowser(InetAddress address, int port) {
    throw new NotSupportedException("browsers on other machines are not supported");
  }
}
