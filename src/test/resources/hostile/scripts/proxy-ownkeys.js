// A proxy with two billion keys.
function initialize() { Object.keys(new Proxy({}, {ownKeys: () => ({length: 2147483647})})); }
