// Vite's bundling of dependencies would lose the address of langevin_rigid.wasm, which lies beside the package's module.
export default { optimizeDeps: { exclude: ['langevin-rigid'] }, build: { target: 'es2022' } };
